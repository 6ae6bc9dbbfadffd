// The angles of the triangles of a mesh.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

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

}  // namespace spineloft::testing
