// Meshes to pull.
#pragma once

#include <cstdint>

#include "engine/mesh/tri_mesh.h"
#include "engine/pull/pull.h"

namespace spineloft::testing {

/// A box with a corner at the origin, each side as two triangles.
mesh::TriMesh box(double width, double height, double depth);
/// A ring about the z axis: a circle of radius `small` at `large` from the axis.
mesh::TriMesh torus(double large, double small, int around = 64, int across = 28);

ModelPoint at(const mesh::TriMesh& mesh, std::uint32_t vertex);

/// reachOf, which is to succeed.
pull::Reach reached(const mesh::TriMesh& mesh, const pull::Pull& pull);

}  // namespace spineloft::testing
