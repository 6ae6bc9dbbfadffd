// Moves a mesh as far as it does not go through itself.
#pragma once

#include <functional>

#include "engine/mesh/tri_mesh.h"

namespace spineloft::mesh {

/// `moveTo(share, out)` makes `out` of `before` with a share of a way done. `out` is all of the way; if it would then
/// go through itself and `before` does not, a half, up to four times, or nothing of it. What was kept: 1 … 0. Cost:
/// that of selfCrossing.
double keptShare(const TriMesh& before, const std::function<void(double share, TriMesh& out)>& moveTo, TriMesh& out);

}  // namespace spineloft::mesh
