// Whether a closed mesh goes through itself, and where. The worker of solids has this test as a WebAssembly program of
// its own (web/self_crossing.cpp).
#pragma once

#include <array>
#include <optional>

#include "engine/mesh/tri_mesh.h"

namespace spineloft::mesh {

/// Share of a mesh's diagonal: what is less deep only touches. Float coordinates are sure to seven digits.
inline constexpr double kTouch = 1e-6;

/// The middle of two triangles of the mesh (its space) that no shift as short as kTouch of its diagonal takes out of
/// one another; none where there are no such two. Neighbours at an edge do not count. Any finite mesh.
std::optional<std::array<double, 3>> selfCrossing(const TriMesh& mesh);

}  // namespace spineloft::mesh
