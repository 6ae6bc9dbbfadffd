// A mesh as it is drawn and exported: vertices doubled where the surface has a crease.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/mesh/tri_mesh.h"

namespace spineloft::mesh {

/// Positions, normals and UV side by side, one a vertex; `uv` is empty when the mesh has none.
/// Triangles are those of the mesh, in the same order.
struct ShadedMesh {
  std::vector<std::array<float, 3>> positions;
  std::vector<std::array<float, 3>> normals;  ///< unit length
  std::vector<std::array<float, 2>> uv;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  bool operator==(const ShadedMesh&) const = default;
};

/// Sharper edges than this look like edges: 40°, in radians. A circle of 12 points stays smooth.
inline constexpr double kCreaseAngle = 0.6981317007977318;

/// Splits vertices along edges whose triangles' normals differ by more than `creaseAngle` (radians,
/// 0…π) and gives every copy the angle-weighted normal of its own smooth patch. All indices must
/// name vertices; edges without exactly two triangles count as creases. Linear.
ShadedMesh shade(const TriMesh& mesh, double creaseAngle = kCreaseAngle);

}  // namespace spineloft::mesh
