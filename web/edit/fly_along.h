// The camera along the bone or rail of a part (cross-sections-hughes 3.2).
#pragma once

#include <vector>

#include "engine/document/document.h"
#include "engine/pipeline/derive.h"
#include "web/ui/ui_state.h"

namespace spineloft::app {

/// Whether the part has a line to fly along: a bone or a rail.
inline bool hasWay(const document::Part& part) {
  const auto* layers = document::stackOf(part);
  return layers ? !layers->rail.points.empty() : document::loftOf(part) != nullptr;
}
/// Cameras at even shares of that line as it is shown, kAlongWay of them: each looks at its place of the line from
/// behind and from the side of the line that faces the viewer, so far away that the part's thickness about the line
/// fills most of the view's height. Empty without such a line, and before the part is derived.
std::vector<Camera> camerasAlong(const document::Document& document, const pipeline::Derived& derived,
                                 const UiState& ui, PartId part);
inline constexpr int kAlongWay = 49;

}  // namespace spineloft::app
