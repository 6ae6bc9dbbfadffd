// Bumps: what is within a ring on a surface rises, and the ring stays.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "engine/base/rng.h"
#include "engine/geometry/polyline.h"
#include "engine/mesh/self_crossing.h"
#include "engine/pull/pull.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/pull_hosts.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::pull;
using testing::at;
using testing::reached;

namespace {

/// A circle of 64 points, square to z.
std::vector<ModelPoint> circle(ModelPoint centre, double radius) {
  std::vector<ModelPoint> points;
  for (int i = 0; i < 64; ++i) {
    const double a = 2 * std::numbers::pi * i / 64;
    points.push_back(centre + ModelPoint{radius * std::cos(a), radius * std::sin(a), 0});
  }
  return points;
}

/// The largest angle between a triangle at the ring before and after.
double steepest(const Reach& reach, const mesh::TriMesh& out) {
  std::vector<bool> moved(out.positions.size(), false);
  for (const auto& [vertex, by] : reach.moved) moved[vertex] = true;
  double most = 0;
  for (const auto& t : out.triangles) {
    if (moved[t[0]] == moved[t[1]] && moved[t[1]] == moved[t[2]]) continue;
    const auto normal = [&](const mesh::TriMesh& mesh) {
      return normalized(cross(at(mesh, t[1]) - at(mesh, t[0]), at(mesh, t[2]) - at(mesh, t[0])));
    };
    most = std::max(most, std::acos(std::clamp(dot(normal(reach.mesh), normal(out)), -1.0, 1.0)));
  }
  return most;
}

/// The largest angles between neighbours that move: of those with an edge on the line, and of the others.
std::pair<double, double> sharpest(const Reach& reach, const mesh::TriMesh& out) {
  std::vector<bool> moved(out.positions.size(), false), line(out.positions.size(), false);
  for (const auto& [vertex, by] : reach.moved) moved[vertex] = true;
  for (const std::uint32_t v : reach.line) line[v] = true;
  std::map<std::pair<std::uint32_t, std::uint32_t>, ModelPoint> normals;
  std::pair<double, double> most;
  for (const auto& t : out.triangles) {
    const ModelPoint normal = normalized(cross(at(out, t[1]) - at(out, t[0]), at(out, t[2]) - at(out, t[0])));
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      if (!moved[a] || !moved[b]) continue;
      const auto [other, isNew] = normals.try_emplace(std::minmax(a, b), normal);
      if (isNew) continue;
      const double angle = std::acos(std::clamp(dot(normal, other->second), -1.0, 1.0));
      double& largest = line[a] && line[b] ? most.first : most.second;
      largest = std::max(largest, angle);
    }
  }
  return most;
}

/// A closed line on the torus of radii 100 and 32, in its angles: an ellipse, or a star.
struct Star {
  explicit Star(Rng& rng)
      : a(rng.uniform(0, 6.28)),
        b(rng.uniform(0, 6.28)),
        wide(rng.uniform(0.08, 0.4)),
        high(rng.uniform(0.2, 1.2)),
        deep(rng.uniform(0, 0.35)),
        spikes(3.0 + static_cast<double>(rng.below(3))) {}
  static ModelPoint place(double around, double across) {
    const double r = 100 + 32 * std::cos(across);
    return {r * std::cos(around), r * std::sin(around), 32 * std::sin(across)};
  }
  ModelPoint top() const { return place(a, b); }
  double reach(double t) const { return 1 + deep * std::sin(spikes * t); }
  std::vector<ModelPoint> line() const {
    std::vector<ModelPoint> points;
    for (int i = 0; i < 120; ++i) {
      const double t = 2 * std::numbers::pi * i / 120;
      points.push_back(place(a + wide * reach(t) * std::cos(t), b + high * reach(t) * std::sin(t)));
    }
    return points;
  }
  /// Whether a place of the torus is within it, or hardly outside.
  bool holds(ModelPoint p) const {
    const double out = std::hypot(p.x, p.y);
    const double x = std::remainder(std::atan2(p.y, p.x) - a, 2 * std::numbers::pi) / wide;
    const double y = std::remainder(std::atan2(p.z, out - 100) - b, 2 * std::numbers::pi) / high;
    return std::hypot(x, y) < reach(std::atan2(y, x)) + 0.05;
  }
  double a, b, wide, high, deep, spikes;
};

}  // namespace

TEST_SUITE_BEGIN("unit/pull");

TEST_CASE("a round bump on a plane is a clamped plate under pressure, with a corner one that is free to turn there") {
  const mesh::TriMesh host = testing::box(400, 400, 60);
  const double height = 30, radius = 100;
  for (const bool corner : {false, true}) {
    const Pull pull{{{200, 200, 60}}, height, {}, 40, corner, circle({200, 200, 60}, radius)};
    const Reach reach = reached(host, pull);
    CHECK(reach.ring.size() > 60);
    mesh::TriMesh out;
    CHECK(pullMesh(reach, pull, out) == 1);
    testing::requireLawful(out);
    double off = 0;
    std::size_t within = 0;
    for (std::uint32_t v = 0; v < out.positions.size(); ++v) {
      const ModelPoint p = at(reach.mesh, v), moved = at(out, v);
      const double s = std::hypot(p.x - 200, p.y - 200) / radius;
      if (p.z < 59 || s > 1) {
        CHECK(distance(p, moved) < 1e-4);
        continue;
      }
      ++within;
      const double told = height * (1 - s * s) * (corner ? (3 - s * s) / 3 : 1 - s * s);
      off = std::max(off, std::abs(moved.z - 60 - told));
    }
    if (!corner) CHECK(steepest(reach, out) < 1.5 * std::numbers::pi / 180);
    CHECK(within > 300);
    CHECK(off < 0.02 * height);
  }
}

TEST_CASE("a bump goes through its profile, and no edge runs along it") {
  const mesh::TriMesh host = testing::box(400, 400, 60);
  for (const bool corner : {false, true}) {
    Pull pull{{{100, 200, 60}, {300, 200, 60}}, 0, {}, 40, corner, circle({200, 200, 60}, 100)};
    // An arch that is steeper on one side; smooth where its ring is.
    for (int i = 0; i <= 40; ++i) {
      const double t = i / 40.0, up = std::sin(std::numbers::pi * std::pow(t, 0.8));
      pull.to.push_back({100 + 200 * t, 200, 60 + 50 * (corner ? up : up * up)});
    }
    pull.to.back().z = 60;
    const Reach reach = reached(host, pull);
    mesh::TriMesh out;
    CHECK(pullMesh(reach, pull, out) == 1);
    testing::requireLawful(out);
    double off = 0;
    for (const std::uint32_t v : reach.line) {
      const ModelPoint p = at(out, v);
      double least = 1e9;
      for (std::size_t i = 0; i + 1 < pull.to.size(); ++i)
        least = std::min(least, geometry::distanceToSegment(p, pull.to[i], pull.to[i + 1]));
      off = std::max(off, least);
    }
    CHECK(off < 0.002 * 200);
    const auto [along, elsewhere] = sharpest(reach, out);
    CHECK(along < 1.2 * elsewhere);
  }
}

TEST_CASE("a bump goes through two profiles that meet") {
  const mesh::TriMesh host = testing::box(400, 400, 60);
  Pull pull{{{100, 200, 60}, {300, 200, 60}}, 0, {}, 40, true, circle({200, 200, 60}, 100)};
  pull.across = {{200, 100, 60}, {200, 300, 60}};
  // The first is an arch, the second a sharper one with the same top.
  for (int i = 0; i <= 40; ++i) {
    const double t = i / 40.0, arch = std::sin(std::numbers::pi * t);
    pull.to.push_back({100 + 200 * t, 200, 60 + 50 * arch});
    pull.acrossTo.push_back({200, 100 + 200 * t, 60 + 50 * arch * arch});
  }
  const Reach reach = reached(host, pull);
  mesh::TriMesh out;
  CHECK(pullMesh(reach, pull, out) == 1);
  testing::requireLawful(out);
  CHECK(!mesh::selfCrossing(out));
  // Of the surface over a profile: how far from it.
  for (const std::vector<ModelPoint>* profile : {&pull.to, &pull.acrossTo}) {
    double off = 0;
    int count = 0;
    for (std::uint32_t v = 0; v < out.positions.size(); ++v) {
      const ModelPoint from = at(reach.mesh, v), p = at(out, v);
      const bool first = profile == &pull.to;
      if (std::abs(first ? from.y - 200 : from.x - 200) > 1e-3 || from.z < 59) continue;
      if (std::abs(first ? from.x - 200 : from.y - 200) > 100) continue;
      double least = 1e9;
      for (std::size_t i = 0; i + 1 < profile->size(); ++i)
        least = std::min(least, geometry::distanceToSegment(p, (*profile)[i], (*profile)[i + 1]));
      off = std::max(off, least);
      ++count;
    }
    CHECK(count > 20);
    CHECK(off < 0.002 * 200);
  }
}

TEST_CASE("random bumps of a torus, out and in, are lawful, keep its handle, and move nothing outside of their ring") {
  Rng rng(11);
  const mesh::TriMesh host = testing::torus(100, 32);
  int whole = 0, all = 0;
  for (int round = 0; round < testing::rounds(50); ++round) {
    CAPTURE(round);
    const Star star(rng);
    const bool corner = rng.below(2) == 0;
    const Pull pull{{star.top()}, rng.uniform(-12, 25), {}, 40, corner, star.line()};
    const Reach reach = reached(host, pull);
    CHECK(testing::requireLawful(reach.mesh).genus == 1);
    REQUIRE(!reach.moved.empty());
    for (const auto& [vertex, by] : reach.moved) CHECK(star.holds(at(reach.mesh, vertex)));
    mesh::TriMesh out;
    const double share = pullMesh(reach, pull, out);
    CHECK(testing::requireLawful(out).genus == 1);
    CHECK(!mesh::selfCrossing(out));
    ++all;
    whole += share == 1;
    double highest = 0;
    for (std::uint32_t v = 0; v < out.positions.size(); ++v)
      highest = std::max(highest, distance(at(reach.mesh, v), at(out, v)));
    CHECK(highest == doctest::Approx(share * std::abs(pull.height)).epsilon(1e-4).scale(1));
  }
  CHECK(whole > 0.8 * all);
}

TEST_CASE("the other side of a thin piece stays where a bump is made, also at its edge") {
  const mesh::TriMesh host = testing::box(400, 400, 8);
  for (const double x : {200.0, 340.0}) {
    const Pull pull{{{x, 200, 8}}, 25, {}, 40, false, circle({x, 200, 8}, 55)};
    const Reach reach = reached(host, pull);
    CHECK(reach.moved.size() > 100);
    for (const auto& [vertex, by] : reach.moved) CHECK(at(reach.mesh, vertex).z == doctest::Approx(8));
    mesh::TriMesh out;
    CHECK(pullMesh(reach, pull, out) == 1);
    testing::requireLawful(out);
  }
}

TEST_CASE("a ring over the edge of a box follows on both of its sides, and one along the edge on its own") {
  const mesh::TriMesh host = testing::box(400, 400, 60);
  // Half of it on the front, half of it on the side.
  std::vector<ModelPoint> over{{380, 150, 60}, {400, 150, 60}, {400, 150, 40}, {400, 250, 40}, {400, 250, 60}};
  over.push_back({380, 250, 60});
  const std::vector<ModelPoint> along{{300, 150, 60}, {400, 150, 60}, {400, 250, 60}, {300, 250, 60}};
  for (const bool corner : {false, true}) {
    const Pull both{{{400, 200, 60}}, 12, {}, 40, corner, over}, front{{{350, 200, 60}}, 12, {}, 40, corner, along};
    const Reach first = reached(host, both), second = reached(host, front);
    const auto onSide = [&](const Reach& reach) {
      return std::ranges::count_if(reach.moved, [&](const auto& m) { return at(reach.mesh, m.vertex).z < 59.9; });
    };
    CHECK(onSide(first) > 20);
    CHECK(onSide(second) == 0);
    for (const auto& [vertex, by] : first.moved) CHECK(at(first.mesh, vertex).z > 39.9);
    CHECK(second.moved.size() > 100);
    for (const auto& [reach, pull] : {std::pair(&first, &both), {&second, &front}}) {
      mesh::TriMesh out;
      CHECK(pullMesh(*reach, *pull, out) == 1);
      testing::requireLawful(out);
    }
  }
}

TEST_CASE("what stands higher than its ring is wide is within it") {
  // A horn: a box of 400 with a tip far above the middle of its front.
  mesh::TriMesh host = testing::box(400, 400, 60);
  const Pull horn{{{200, 200, 60}}, 160, {}, 40, false, circle({200, 200, 60}, 50)};
  mesh::TriMesh tall;
  CHECK(pullMesh(reached(host, horn), horn, tall) == 1);
  const Pull pull{{{200, 200, 220}}, 20, {}, 40, false, circle({200, 200, 60}, 60)};
  const Reach reach = reached(tall, pull);
  REQUIRE(reach.line.size() == 1);
  mesh::TriMesh out;
  CHECK(pullMesh(reach, pull, out) == 1);
  testing::requireLawful(out);
  double highest = 0;
  for (std::uint32_t v = 0; v < out.positions.size(); ++v) highest = std::max(highest, at(out, v).z);
  CHECK(highest > 224);
}

TEST_CASE("a ring round an arm has its top's side within it") {
  // A bar along x; what is beyond x = 300 follows its end.
  const mesh::TriMesh host = testing::box(400, 60, 60);
  const std::vector<ModelPoint> ring{{300, 0, 0}, {300, 60, 0}, {300, 60, 60}, {300, 0, 60}};
  for (const double end : {400.0, 0.0}) {
    const Pull pull{{{end, 30, 30}}, 15, {}, 40, false, ring};
    const Reach reach = reached(host, pull);
    CHECK(reach.moved.size() > 50);
    for (const auto& [vertex, by] : reach.moved) CHECK((at(reach.mesh, vertex).x > 300) == (end > 300));
  }
}

TEST_CASE("a ring of no area, or one that its top is outside of, moves nothing") {
  const mesh::TriMesh host = testing::box(400, 400, 60);
  const std::vector<ModelPoint> line{{100, 200, 60}, {200, 200, 60}, {300, 200, 60}};
  for (const Pull& pull : {Pull{{{200, 200, 60}}, 20, {}, 40, false, line},
                           Pull{{{350, 350, 60}}, 20, {}, 40, false, circle({150, 150, 60}, 50)},
                           Pull{{{200, 200, 60}}, 20, {}, 40, true, {{5, 5, 60}, {5, 5, 60}, {5, 5, 60}}}}) {
    mesh::TriMesh out;
    const Reach reach = reached(host, pull);
    CHECK(reach.moved.empty());
    CHECK(pullMesh(reach, pull, out) == 0);
    testing::requireLawful(out);
  }
}

TEST_CASE("a ring or a line across that cannot be is refused") {
  const Pull good{{{1, 2, 3}}, 5, {}, 20, false, circle({1, 2, 3}, 4)};
  CHECK(checkPulls({good}).ok());
  const auto refused = [&](const auto& change) {
    Pull bad = good;
    change(bad);
    CHECK(checkPulls({good, bad}).error() == Error::ValueOutOfRange);
  };
  refused([](Pull& pull) { pull.ring.resize(2); });
  refused([](Pull& pull) { pull.ring[1].y = std::nan(""); });
  refused([](Pull& pull) { pull.ring.resize(kMostLinePoints + 1); });
  refused([](Pull& pull) { pull.across = {{1, 2, std::nan("")}}; });
  refused([](Pull& pull) { pull.acrossTo = {{1, 2, 3}}; });
  refused([](Pull& pull) {
    pull.across = {{1, 2, 3}};
    pull.to = {{1, 2, 3}};
  });
}

TEST_SUITE_END();
