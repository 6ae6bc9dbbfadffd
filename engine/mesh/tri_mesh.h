// Triangle meshes as plain values.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/base/vec.h"

namespace spineloft::mesh {

/// A triangle mesh in a space that its user names (parts: ModelSpace; see base/vec.h).
/// `positions` are shared by topology: one entry a vertex of the closed surface. `uv` (empty, or one a
/// vertex) is in the picture: u right 0…1, v down 0…1. Triangles are counter-clockwise seen from
/// outside in a right-handed space.
struct TriMesh {
  std::vector<std::array<float, 3>> positions;
  std::vector<std::array<float, 2>> uv;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  bool operator==(const TriMesh&) const = default;
};

}  // namespace spineloft::mesh
