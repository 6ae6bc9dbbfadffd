#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <vector>

#include "engine/base/rng.h"
#include "engine/mesh/self_crossing.h"
#include "engine/pull/pull.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/pull_hosts.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::pull;
using testing::at;
using testing::box;
using testing::reached;

namespace {

mesh::TriMesh scaled(mesh::TriMesh mesh, float by) {
  for (auto& p : mesh.positions) p = {p[0] * by, p[1] * by, p[2] * by};
  return mesh;
}

/// A line over the ring from one place of it to another.
std::vector<ModelPoint> lineOnRing(Rng& rng) {
  const double from = rng.uniform(0, 6), to = from + rng.uniform(-1.5, 1.5), side = rng.uniform(0, 6);
  const double turn = rng.uniform(-2, 2);
  std::vector<ModelPoint> line;
  for (int i = 0; i <= 6; ++i) {
    const double a = from + (to - from) * i / 6, b = side + turn * i / 6, r = 100 + 32 * std::cos(b);
    line.push_back({r * std::cos(a), r * std::sin(a), 32 * std::sin(b)});
  }
  if (rng.below(3) == 0) line.resize(1);
  return line;
}

}  // namespace

TEST_CASE("a flat piece pulled along its middle follows 1 - 3t^2 + 2t^3, a crease 1 - t, wherever its triangles lie") {
  const double height = 30, radius = 100;
  for (const bool crease : {false, true}) {
    for (const double middle : {200.0, 187.3, 201.7, 219.21}) {
      CAPTURE(crease);
      CAPTURE(middle);
      const Pull pull{{{-10, middle, 20}, {1210, middle, 20}}, height, {}, radius, crease};
      mesh::TriMesh out;
      CHECK(pullMesh(reached(box(1200, 400, 20), pull), pull, out) == 1);
      CHECK(testing::requireLawful(out).genus == 0);
      double worst = 0, beyond = 0;
      int seen = 0;
      for (const auto& p : out.positions) {
        const bool onTop = p[0] > 300 && p[0] < 900 && p[1] > 0 && p[1] < 400 && p[2] > 10;
        if (!onTop) continue;
        ++seen;
        const double t = std::abs(p[1] - middle) / radius;
        const double told = height * (t >= 1 ? 0 : crease ? 1 - t : 1 - 3 * t * t + 2 * t * t * t);
        (t >= 1 ? beyond : worst) = std::max(t >= 1 ? beyond : worst, std::abs(p[2] - 20 - told));
      }
      CHECK(seen > 1000);
      CHECK(worst < 0.01 * height);
      CHECK(beyond < 1e-6);
    }
  }
}

TEST_CASE("line and rim are cut in without a change of the surface, and nothing beyond the radius moves") {
  Rng rng(7);
  const mesh::TriMesh host = testing::torus(100, 32);
  const double volume = testing::requireLawful(host).volume;
  for (int round = 0; round < testing::rounds(60); ++round) {
    CAPTURE(round);
    const Pull pull{lineOnRing(rng), rng.uniform(-15, 40), {}, rng.uniform(8, 60), rng.below(2) == 0};
    const Reach reach = reached(host, pull);
    const mesh::MeshReport cut = testing::requireLawful(reach.mesh);
    CHECK(cut.genus == 1);
    CHECK(cut.volume == doctest::Approx(volume).epsilon(2e-3));
    REQUIRE(!reach.line.empty());
    std::set<std::uint32_t> moved;
    for (const auto& [vertex, by] : reach.moved) moved.insert(vertex);
    for (const std::uint32_t vertex : reach.line) CHECK(moved.contains(vertex));
    const auto away = [&](std::uint32_t vertex) {
      double least = std::numeric_limits<double>::infinity();
      for (const std::uint32_t on : reach.line)
        least = std::min(least, distance(at(reach.mesh, on), at(reach.mesh, vertex)));
      return least;
    };
    for (const std::uint32_t vertex : moved) CHECK(away(vertex) < 1.02 * pull.radius);
    mesh::TriMesh out;
    const double share = pullMesh(reach, pull, out);
    CHECK(testing::requireLawful(out).genus == 1);
    CHECK(!mesh::selfCrossing(out));
    for (std::uint32_t vertex = 0; vertex < host.positions.size(); ++vertex) {
      if (away(vertex) > 1.1 * pull.radius) CHECK(out.positions[vertex] == host.positions[vertex]);
    }
    for (const std::uint32_t vertex : reach.line) {
      const double way = distance(at(reach.mesh, vertex), at(out, vertex));
      CHECK(way == doctest::Approx(share * std::abs(pull.height)).epsilon(1e-4).scale(1));
    }
  }
}

TEST_CASE("a pull of a solid that is twice as large is twice as large") {
  const mesh::TriMesh host = testing::torus(100, 32);
  const Pull small{{{132, 0, 0}, {120, 40, 20}}, 12, {}, 30, false};
  const Pull large{{{264, 0, 0}, {240, 80, 40}}, 24, {}, 60, false};
  mesh::TriMesh a, b;
  pullMesh(reached(host, small), small, a);
  pullMesh(reached(scaled(host, 2), large), large, b);
  REQUIRE(a.triangles == b.triangles);
  for (std::uint32_t v = 0; v < a.positions.size(); ++v) CHECK(distance(2 * at(a, v), at(b, v)) < 1e-3);
}

TEST_CASE("a line that is told where to go lies there, whichever way round both were drawn") {
  const mesh::TriMesh host = box(200, 200, 200);
  const std::vector<ModelPoint> to{{40, 110, 240}, {100, 120, 260}, {160, 110, 240}};
  Pull pull{{{40, 100, 200}, {160, 100, 200}}, 5, to, 60, false};
  const Reach reach = reached(host, pull);
  mesh::TriMesh out;
  CHECK(pullMesh(reach, pull, out) == 1);
  testing::requireLawful(out);
  CHECK(distance(at(out, reach.line.front()), to.front()) < 0.5);
  CHECK(distance(at(out, reach.line.back()), to.back()) < 0.5);
  double nearest = 1e9;
  for (const std::uint32_t v : reach.line) nearest = std::min(nearest, distance(at(out, v), to[1]));
  CHECK(nearest < 3);
  std::ranges::reverse(pull.line);
  std::ranges::reverse(pull.to);
  mesh::TriMesh turned;
  pullMesh(reached(host, pull), pull, turned);
  CHECK(testing::requireLawful(turned).volume == doctest::Approx(testing::requireLawful(out).volume).epsilon(1e-3));
}

TEST_CASE("a line that goes to a single place goes there as it is, with its middle") {
  const mesh::TriMesh host = box(200, 200, 200);
  const Pull pull{{{60, 100, 200}, {100, 100, 200}, {140, 100, 200}}, 0, {{100, 100, 230}}, 50, false};
  const Reach reach = reached(host, pull);
  mesh::TriMesh out;
  CHECK(pullMesh(reach, pull, out) == 1);
  testing::requireLawful(out);
  for (const std::uint32_t v : reach.line) CHECK(at(out, v).z == doctest::Approx(230).epsilon(0.01));
}

TEST_CASE("lines far longer than their radius, and meshes that are not closed, give a mesh that is no worse") {
  const mesh::TriMesh host = box(8000, 300, 40);
  const Pull thin{{{0, 150, 40}, {8000, 150, 40}}, 3, {}, 4, false};
  mesh::TriMesh out;
  pullMesh(reached(host, thin), thin, out);
  testing::requireLawful(out);
  mesh::TriMesh open = box(200, 200, 200);
  open.triangles.resize(2);
  for (const ModelPoint p : {ModelPoint{100, 100, 200}, ModelPoint{0, 0, 200}, ModelPoint{200, 100, 200}}) {
    const Pull pull{{p}, 20, {}, 60, false};
    const Reach reach = reached(open, pull);
    pullMesh(reach, pull, out);
    for (const auto& t : out.triangles) {
      for (const std::uint32_t v : t) CHECK(v < out.positions.size());
    }
  }
  mesh::TriMesh flat = box(0, 0, 0);
  const Pull nowhere{{{1, 2, 3}}, 20, {}, 60, false};
  CHECK(pullMesh(reached(flat, nowhere), nowhere, out) == 0);
  CHECK(out == flat);
}

TEST_CASE("a crease has an edge along its line, a smooth pull none") {
  const mesh::TriMesh host = box(400, 300, 60);
  double slopes[2] = {};
  for (const bool crease : {false, true}) {
    const Pull pull{{{-10, 150, 60}, {410, 150, 60}}, 40, {}, 80, crease};
    mesh::TriMesh out;
    pullMesh(reached(host, pull), pull, out);
    // How far the surface has fallen where it is a twelfth of the radius beside the line.
    double fallen = 0;
    for (const auto& p : out.positions) {
      const double beside = std::abs(p[1] - 150);
      if (p[0] < 150 || p[0] > 250 || p[2] < 61 || beside < 2 || beside > 8) continue;
      fallen = std::max(fallen, (100 - static_cast<double>(p[2])) / beside);
    }
    slopes[crease ? 1 : 0] = fallen;
  }
  CHECK(slopes[1] == doctest::Approx(0.5).epsilon(0.03));  // 40 over 80
  CHECK(slopes[0] < 0.15);
}

TEST_CASE("a thin piece is pulled on one side: its other side stays where the surface leads to it on a long way only") {
  const mesh::TriMesh host = box(600, 600, 8);
  const Pull pull{{{300, 300, 8}}, 30, {}, 60, false};
  const Reach reach = reached(host, pull);
  CHECK(reach.moved.size() > 100);
  for (const auto& [vertex, by] : reach.moved) CHECK(at(reach.mesh, vertex).z == doctest::Approx(8));
}

TEST_CASE("what would go through itself goes as far as it can") {
  const mesh::TriMesh host = box(200, 200, 40);
  const Pull pull{{{100, 100, 40}}, -200, {}, 60, false};
  const Reach reach = reached(host, pull);
  mesh::TriMesh out;
  const double share = pullMesh(reach, pull, out);
  CHECK(share < 1);
  CHECK(share > 0);
  CHECK(!mesh::selfCrossing(out));
  testing::requireLawful(out);
}

TEST_CASE("a radius larger than the part leaves some of it where it is") {
  const mesh::TriMesh host = box(100, 100, 100);
  const Pull pull{{{50, 50, 100}}, 20, {}, 5000, false};
  const Reach reach = reached(host, pull);
  CHECK(reach.moved.size() < reach.mesh.positions.size());
  mesh::TriMesh out;
  CHECK(pullMesh(reach, pull, out) == 1);
  testing::requireLawful(out);
}

TEST_CASE("a pull with a number or a line that cannot be is refused") {
  const Pull good{{{1, 2, 3}}, 5, {}, 20, false};
  CHECK(checkPulls({good}).ok());
  const auto refused = [&](const auto& change) {
    Pull bad = good;
    change(bad);
    CHECK(checkPulls({good, bad}).error() == Error::ValueOutOfRange);
    CHECK(reachOf(box(10, 10, 10), bad).error() == Error::ValueOutOfRange);
  };
  refused([](Pull& pull) { pull.line.clear(); });
  refused([](Pull& pull) { pull.line[0].z = std::nan(""); });
  refused([](Pull& pull) { pull.line[0].x = 1e9; });
  refused([](Pull& pull) { pull.to = {{1, 2, std::numeric_limits<double>::infinity()}}; });
  refused([](Pull& pull) { pull.line.resize(kMostLinePoints + 1); });
  refused([](Pull& pull) { pull.radius = std::nan(""); });
  refused([](Pull& pull) { pull.radius = 0; });
  refused([](Pull& pull) { pull.height = 1e9; });
  CHECK(checkPulls(std::vector<Pull>(kMostPulls + 1, good)).error() == Error::ValueOutOfRange);
}
