// Rings on a part, and the bumps that are made of them.
#pragma once

#include <optional>
#include <vector>

#include "web/edit/pulling.h"

namespace spineloft::app {

/// The ring that a line on the surface makes: the line comes back to its beginning (what is drawn beyond it is left
/// out) round something, and does not cross itself. 48 points. None: it is a line. `line` ≥ 1 point.
std::optional<std::vector<ModelPoint>> ringOf(const std::vector<ModelPoint>& line);
/// The place of the surface before the place that is deepest within a ring, seen along the ring's normal. None: nothing
/// is there. `ring` ≥ 3 points.
std::optional<ModelPoint> topOf(const mesh::TriMesh& mesh, const std::vector<ModelPoint>& ring);
/// A bump within a ring with its top there, out by three quarters of its radius (twice the area within by the ring's
/// length), of the sharpness that the tool is set to.
pull::Pull usualBump(const EditOptions& options, const std::vector<ModelPoint>& ring, ModelPoint top);
/// All that a bump has, larger about the middle of its ring, as far as pulls may be small and parts of that size are
/// wide.
void widenBump(pull::Pull& bump, double factor, double size);
/// A circle on the surface as it is seen, its middle in the middle of the view, as wide as the tool is set to or, where
/// the part is narrow, narrower. Empty: the part is not there.
std::vector<ModelPoint> circleInView(const PulledPart& part, const UiState& ui);

}  // namespace spineloft::app
