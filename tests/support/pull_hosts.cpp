#include "tests/support/pull_hosts.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace spineloft::testing {

mesh::TriMesh box(double width, double height, double depth) {
  mesh::TriMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.positions.push_back({static_cast<float>((i & 1) ? width : 0), static_cast<float>((i & 2) ? height : 0),
                              static_cast<float>((i & 4) ? depth : 0)});
    mesh.uv.push_back({(i & 1) ? 1.0f : 0.0f, (i & 2) ? 0.0f : 1.0f});
  }
  mesh.triangles = {{4, 5, 7}, {4, 7, 6}, {0, 2, 3}, {0, 3, 1}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

mesh::TriMesh ball(ModelPoint centre, double radius, int rings) {
  mesh::TriMesh out;
  const int around = 2 * rings;
  const auto add = [&](double level, double turn) {
    const double down = std::numbers::pi * level / rings, side = 2 * std::numbers::pi * turn / around;
    const ModelPoint p =
        centre + ModelPoint{std::sin(down) * std::cos(side), std::cos(down), -std::sin(down) * std::sin(side)} * radius;
    out.positions.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  };
  add(0, 0);
  for (int level = 1; level < rings; ++level) {
    for (int i = 0; i < around; ++i) add(level, i);
  }
  add(rings, 0);
  const auto last = static_cast<std::uint32_t>(out.positions.size() - 1);
  const auto corner = [&](int level, int i) {
    if (level == 0) return 0u;
    return level == rings ? last : static_cast<std::uint32_t>(1 + (level - 1) * around + i % around);
  };
  for (int level = 0; level < rings; ++level) {
    for (int i = 0; i < around; ++i) {
      if (level > 0) out.triangles.push_back({corner(level, i), corner(level + 1, i), corner(level, i + 1)});
      if (level < rings - 1)
        out.triangles.push_back({corner(level, i + 1), corner(level + 1, i), corner(level + 1, i + 1)});
    }
  }
  return out;
}

mesh::TriMesh torus(double large, double small, int around, int across) {
  mesh::TriMesh mesh;
  for (int i = 0; i < around; ++i) {
    const double a = 2 * std::numbers::pi * i / around;
    for (int k = 0; k < across; ++k) {
      const double b = 2 * std::numbers::pi * k / across, r = large + small * std::cos(b);
      mesh.positions.push_back({static_cast<float>(r * std::cos(a)), static_cast<float>(r * std::sin(a)),
                                static_cast<float>(small * std::sin(b))});
    }
  }
  const auto at = [&](int i, int k) { return static_cast<std::uint32_t>((i % around) * across + k % across); };
  for (int i = 0; i < around; ++i) {
    for (int k = 0; k < across; ++k) {
      mesh.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      mesh.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  }
  return mesh;
}

ModelPoint at(const mesh::TriMesh& mesh, std::uint32_t vertex) {
  const auto& p = mesh.positions[vertex];
  return {p[0], p[1], p[2]};
}

pull::Reach reached(const mesh::TriMesh& mesh, const pull::Pull& pull) {
  Result<pull::Reach> reach = pull::reachOf(mesh, pull);
  REQUIRE(reach.ok());
  return std::move(reach).value();
}

}  // namespace spineloft::testing
