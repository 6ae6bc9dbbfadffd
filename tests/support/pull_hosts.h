// Meshes to pull, and for bridges to stand on.
#pragma once

#include <cstdint>

#include "engine/mesh/tri_mesh.h"
#include "engine/pull/pull.h"

namespace spineloft::testing {

/// A box with a corner at the origin, each side as two triangles.
mesh::TriMesh box(double width, double height, double depth);
/// A ball: `rings` levels from pole to pole along y, twice as many corners around.
mesh::TriMesh ball(ModelPoint centre, double radius, int rings = 32);
/// A ring about the z axis: a circle of radius `small` at `large` from the axis.
mesh::TriMesh torus(double large, double small, int around = 64, int across = 28);

ModelPoint at(const mesh::TriMesh& mesh, std::uint32_t vertex);

/// reachOf, which is to succeed.
pull::Reach reached(const mesh::TriMesh& mesh, const pull::Pull& pull);

}  // namespace spineloft::testing
