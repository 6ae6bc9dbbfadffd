// Triangles of what is to be printed, as its checks look at them.
#pragma once

#include <array>
#include <cstdint>

#include "engine/base/vec.h"
#include "engine/mesh/tri_mesh.h"

namespace spineloft::printing {

/// Millimetres, y up.
using Point = Vec3<struct PrintSpace>;
using Corners = std::array<Point, 3>;

/// The corners of a triangle of the mesh, whose indices must name vertices.
inline Corners cornersOf(const mesh::TriMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  Corners corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& p = mesh.positions[triangle[i]];
    corners[i] = {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
  }
  return corners;
}

}  // namespace spineloft::printing
