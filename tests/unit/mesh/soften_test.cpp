#include "engine/mesh/soften.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/mesh/laws.h"
#include "engine/mesh/topology.h"
#include "tests/support/mesh_laws.h"

using namespace spineloft;
using namespace spineloft::testing;

namespace {

constexpr int kCells = 8;

/// A roof: two slopes that meet at the height `kCells` over x = 0, closed below and at both ends.
struct Roof {
  mesh::TriMesh mesh;
  std::vector<std::uint32_t> ridge;

  Roof() {
    const auto add = [&](double x, double y, double z) {
      mesh.positions.push_back({static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
      mesh.uv.push_back({0.5f, 0.5f});
      return static_cast<std::uint32_t>(mesh.positions.size() - 1);
    };
    constexpr int kColumns = 2 * kCells;
    std::vector<std::vector<std::uint32_t>> rows;
    std::vector<std::uint32_t> floor;
    for (int j = 0; j <= kCells; ++j) {
      std::vector<std::uint32_t>& row = rows.emplace_back();
      for (int i = -kCells; i <= kCells; ++i) row.push_back(add(i, kCells - std::abs(i), j));
      ridge.push_back(row[kCells]);
      floor.push_back(add(0, 0, j));
    }
    const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    };
    for (std::size_t j = 0; j < kCells; ++j) {
      for (std::size_t i = 0; i < kColumns; ++i) quad(rows[j][i], rows[j + 1][i], rows[j + 1][i + 1], rows[j][i + 1]);
      quad(rows[j].front(), floor[j], floor[j + 1], rows[j + 1].front());
      quad(floor[j], rows[j].back(), rows[j + 1].back(), floor[j + 1]);
    }
    for (const std::size_t j : {std::size_t{0}, std::size_t{kCells}}) {
      for (std::size_t i = 0; i < kColumns; ++i) {
        const std::uint32_t a = floor[j], b = rows[j][i], c = rows[j][i + 1];
        j == 0 ? mesh.triangles.push_back({a, b, c}) : mesh.triangles.push_back({a, c, b});
      }
    }
  }
};

}  // namespace

TEST_CASE("a softened ridge is lower and round, and what is fixed or out of reach stays") {
  const Roof roof;
  requireLawful(roof.mesh);
  mesh::TriMesh soft = roof.mesh;
  std::vector<std::uint32_t> regions(soft.positions.size(), 0);
  for (std::size_t v = 0; v < regions.size(); ++v) {
    if (soft.positions[v][2] == 0 || soft.positions[v][2] == kCells) regions[v] = mesh::kFixed;
  }
  const std::vector<std::uint32_t> before = regions;
  constexpr double kReach = 3;
  mesh::soften(soft, {{roof.ridge, 0, kReach}}, regions);
  const mesh::MeshReport report = requireLawful(soft);
  CHECK(report.volume < requireLawful(roof.mesh).volume);
  CHECK(regions.size() == soft.positions.size());
  CHECK(soft.positions.size() > roof.mesh.positions.size());  // edges were too long
  double highest = 0;
  for (std::size_t v = 0; v < roof.mesh.positions.size(); ++v) {
    const auto &p = roof.mesh.positions[v], &q = soft.positions[v];
    if (before[v] == mesh::kFixed || std::abs(p[0]) * std::sqrt(2.0f) > kReach) CHECK(p == q);
    if (p[2] == kCells / 2) highest = std::max<double>(highest, q[1]);
  }
  CHECK(highest < kCells - 0.3);
  CHECK(highest > kCells - kReach);
}

TEST_CASE("softening does not depend on how a mesh is turned or how large it is") {
  const Roof roof;
  const auto softened = [&](mesh::TriMesh mesh, double scale) {
    std::vector<std::uint32_t> regions(mesh.positions.size(), 0);
    mesh::soften(mesh, {{roof.ridge, 0, 3 * scale}}, regions);
    return mesh;
  };
  mesh::TriMesh other = roof.mesh;
  for (auto& [x, y, z] : other.positions) {
    const float old = x;
    x = 10 * y;
    y = -10 * old;
    z = 10 * z;
  }
  const mesh::TriMesh plain = softened(roof.mesh, 1), turned = softened(other, 10);
  REQUIRE(plain.positions.size() == turned.positions.size());
  for (std::size_t v = 0; v < plain.positions.size(); ++v) {
    const auto& [x, y, z] = plain.positions[v];
    const auto& q = turned.positions[v];
    CHECK(std::abs(q[0] - 10 * y) + std::abs(q[1] + 10 * x) + std::abs(q[2] - 10 * z) < 2e-3);
  }
}

TEST_CASE("what is still sharp after softening has smaller triangles, which follow the bend") {
  const Roof roof;
  mesh::TriMesh soft = roof.mesh;
  std::vector<std::uint32_t> regions(soft.positions.size(), 0);
  for (std::size_t v = 0; v < regions.size(); ++v) {
    if (soft.positions[v][1] == 0) regions[v] = mesh::kFixed;  // the floor
  }
  constexpr double kReach = 0.9;  // less than the roof's triangles are long
  mesh::soften(soft, {{roof.ridge, 0, kReach}}, regions);
  requireLawful(soft);
  const mesh::Twins twins = mesh::findTwins(soft);
  const auto at = [&](std::uint32_t v) {
    const auto& p = soft.positions[v];
    return ModelPoint{p[0], p[1], p[2]};
  };
  const auto normal = [&](std::uint32_t h) {
    const auto& t = soft.triangles[h / 3];
    return normalized(cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0])));
  };
  double sharpest = 1;
  int ridge = 0;
  for (std::uint32_t h = 0; h < twins.of.size(); ++h) {
    const ModelPoint a = at(mesh::cornerVertex(soft, h)), b = at(mesh::cornerVertex(soft, mesh::nextHalfEdge(h)));
    const bool onRidge = std::min(a.y, b.y) > kCells - 1 && std::max(a.z, b.z) < kCells - 1 && std::min(a.z, b.z) > 1;
    ridge += onRidge;
    if (onRidge) sharpest = std::min(sharpest, dot(normal(h), normal(twins.of[h])));
  }
  CHECK(ridge > 20);
  CHECK(sharpest > std::cos(42 * std::numbers::pi / 180));  // 90 degrees before, 49 without the smaller ones
}
