// The outline of a solid as it is seen, drawn anew.
#pragma once

#include <optional>
#include <vector>

#include "web/edit/pulling.h"

namespace spineloft::app {

/// The pull that takes the stretch of the outline beside a stroke, also behind the part, of any of its copies, to the
/// stroke. `stroke`: CSS pixels of the canvas, from the outline to the outline. Its radius is that of the tool, or as
/// far as the outline goes. None: an end of the stroke is farther than `reach` from the outline, or no outline leads
/// from one to the other.
std::optional<pull::Pull> redrawnOutline(const PulledPart& part, const UiState& ui,
                                         const std::vector<ClientPoint>& stroke, double reach);

}  // namespace spineloft::app
