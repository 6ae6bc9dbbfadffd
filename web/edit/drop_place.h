// Where a section that is dropped on the picture belongs.
#pragma once

#include "engine/document/document.h"
#include "engine/pipeline/derive.h"
#include "web/ui/ui_state.h"

namespace spineloft::app {

/// The part and the place on its spine that a section dropped at `at` is for; no part elsewhere.
struct DropPlace {
  PartId part;
  double at = 0;  ///< share of the spine's length, 0…1
};
DropPlace dropPlace(const document::Document& document, const pipeline::Derived& derived, const UiState& ui,
                    ClientPoint at);

}  // namespace spineloft::app
