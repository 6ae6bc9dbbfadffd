// The angles of the triangles of a mesh.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/mesh/topology.h"
#include "engine/mesh/tri_mesh.h"

namespace spineloft::testing {

/// All of them, degrees, from small to large.
inline std::vector<double> anglesOf(const mesh::TriMesh& mesh) {
  std::vector<double> angles;
  for (const auto& t : mesh.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto at = [&](std::size_t k) {
        const auto& p = mesh.positions[t[(c + k) % 3]];
        return ModelPoint{p[0], p[1], p[2]};
      };
      const ModelPoint a = at(1) - at(0), b = at(2) - at(0);
      angles.push_back(std::atan2(norm(cross(a, b)), dot(a, b)) * 180 / std::numbers::pi);
    }
  }
  std::ranges::sort(angles);
  return angles;
}

/// Calls visit(a, b, angle) for every edge of a closed mesh once: its ends, and how far the surface turns there,
/// degrees.
template <class Visit>
void eachDihedral(const mesh::TriMesh& mesh, const Visit& visit) {
  const mesh::Twins twins = mesh::findTwins(mesh);
  const auto corner = [&](std::uint32_t half) {
    const auto& p = mesh.positions[mesh::cornerVertex(mesh, half)];
    return ModelPoint{p[0], p[1], p[2]};
  };
  const auto normalOf = [&](std::uint32_t half) {
    return normalized(
        cross(corner(mesh::nextHalfEdge(half)) - corner(half), corner(mesh::lastHalfEdge(half)) - corner(half)));
  };
  for (std::uint32_t h = 0; h < twins.of.size(); ++h) {
    if (twins.of[h] < h) continue;
    const double cosine = std::clamp(dot(normalOf(h), normalOf(twins.of[h])), -1.0, 1.0);
    visit(corner(h), corner(mesh::nextHalfEdge(h)), std::acos(cosine) * 180 / std::numbers::pi);
  }
}

}  // namespace spineloft::testing
