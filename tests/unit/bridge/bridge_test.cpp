// Bridges: tubes that leave two surfaces tangentially.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/base/rng.h"
#include "engine/bridge/bridge.h"
#include "engine/geometry/turn.h"
#include "engine/mesh/self_crossing.h"
#include "engine/mesh/surface_places.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/pull_hosts.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::bridge;
using testing::at;
using testing::ball;

namespace {

constexpr mesh::PictureSize kPicture{1000, 800};
constexpr double kDegree = std::numbers::pi / 180;
using Points = std::vector<ModelPoint>;

Points circle(ModelPoint centre, ModelPoint normal, double radius) {
  normal = normalized(normal);
  const ModelPoint right =
      normalized(cross(std::abs(normal.y) < 0.9 ? ModelPoint{0, 1, 0} : ModelPoint{1, 0, 0}, normal));
  Points points;
  for (int i = 0; i < 24; ++i) {
    const double a = 2 * std::numbers::pi * i / 24;
    points.push_back(centre + right * (radius * std::cos(a)) + cross(normal, right) * (radius * std::sin(a)));
  }
  return points;
}
/// A circle on a ball, round the place where a direction leaves it.
Points onBall(ModelPoint centre, double radius, ModelPoint out, double rim) {
  return circle(centre + normalized(out) * std::sqrt(radius * radius - rim * rim), out, rim);
}

/// One that is to be made, lawful.
Bridge made(const Host& from, const Host& to, const BridgeParams& params = {}) {
  const Result<Bridge> bridge = makeBridge(from, to, params, kPicture);
  REQUIRE(bridge.ok());
  const mesh::MeshReport report = testing::requireLawful(bridge.value().mesh);
  CHECK(report.genus == 0);
  CHECK(report.shells == 1);
  CHECK_FALSE(mesh::selfCrossing(bridge.value().mesh));
  return bridge.value();
}

// Its rings, one after the other: all corners but the middles of its two lids.
constexpr std::size_t kSides = 64;
std::size_t ringsOf(const Bridge& bridge) { return (bridge.mesh.positions.size() - 2) / kSides; }
Points ringOf(const Bridge& bridge, std::size_t ring) {
  Points points;
  for (std::size_t i = 0; i < kSides; ++i)
    points.push_back(at(bridge.mesh, static_cast<std::uint32_t>(kSides * ring + i)));
  return points;
}
ModelPoint meanOf(const Points& points) {
  ModelPoint sum;
  for (const ModelPoint p : points) sum += p;
  return sum / static_cast<double>(points.size());
}
double radiusOf(const Points& ring) {
  double sum = 0;
  for (const ModelPoint p : ring) sum += distance(p, meanOf(ring));
  return sum / static_cast<double>(ring.size());
}

/// The largest angle between the triangles of its first ring, or its last, and a ball that it leaves.
double angleAt(const Bridge& bridge, std::size_t end, ModelPoint centre) {
  const std::size_t last = 2 * kSides * (ringsOf(bridge) - 2), first = end == 0 ? 0 : last;
  double most = 0;
  for (std::size_t t = first; t < first + 2 * kSides; ++t) {
    const auto& corners = bridge.mesh.triangles[t];
    const ModelPoint middle =
        (at(bridge.mesh, corners[0]) + at(bridge.mesh, corners[1]) + at(bridge.mesh, corners[2])) / 3;
    const ModelPoint normal = normalized(mesh::areaNormal(bridge.mesh, static_cast<std::uint32_t>(t)));
    most = std::max(most, std::acos(std::clamp(dot(normal, normalized(middle - centre)), -1.0, 1.0)));
  }
  return most;
}

}  // namespace

TEST_CASE("a bridge leaves two balls tangentially, from rims that lie on them, and is as thin as asked in its middle") {
  const ModelPoint a{0, 0, 0}, b{240, 60, -40};
  const mesh::TriMesh one = ball(a, 80, 96), two = ball(b, 60, 96);
  for (const double waist : {0.3, 0.6, 0.85}) {
    const Bridge bridge = made({one, onBall(a, 80, b - a, 36)}, {two, onBall(b, 60, a - b, 36)}, {waist, 1});
    CHECK(angleAt(bridge, 0, a) < 1.2 * kDegree);
    CHECK(angleAt(bridge, 1, b) < 1.2 * kDegree);
    for (const ModelPoint p : bridge.rims[0].points) CHECK(std::abs(distance(p, a) - 80) < 0.003 * 36);
    for (const ModelPoint p : bridge.rims[1].points) CHECK(std::abs(distance(p, b) - 60) < 0.003 * 36);
    double thinnest = 1e9;
    for (std::size_t i = 0; i < ringsOf(bridge); ++i) thinnest = std::min(thinnest, radiusOf(ringOf(bridge, i)));
    CHECK(thinnest == doctest::Approx(waist * 36).epsilon(0.06));
    CHECK(dot(bridge.rims[0].out, normalized(b - a)) > 0.999);
    CHECK(dot(bridge.rims[1].out, normalized(a - b)) > 0.999);
  }
}

TEST_CASE("both ends lie in their balls, so that all three are one piece") {
  const ModelPoint a{0, 0, 0}, b{200, 0, 0};
  const mesh::TriMesh one = ball(a, 80), two = ball(b, 80);
  const Bridge bridge = made({one, onBall(a, 80, b - a, 40)}, {two, onBall(b, 80, a - b, 40)});
  const auto apothem = [](double radius) { return radius * std::cos(std::numbers::pi / 64); };  // of the ball's facets
  for (const ModelPoint p : ringOf(bridge, 0)) CHECK(distance(p, a) < 80);
  for (const ModelPoint p : ringOf(bridge, ringsOf(bridge) - 1)) CHECK(distance(p, b) < 80);
  const auto count = static_cast<std::uint32_t>(bridge.mesh.positions.size());
  CHECK(distance(at(bridge.mesh, count - 2), a) < apothem(80));
  CHECK(distance(at(bridge.mesh, count - 1), b) < apothem(80));
}

TEST_CASE("an end of a bridge stays inside of a thin host") {
  const mesh::TriMesh plate = testing::box(400, 400, 8), other = ball({200, 200, 200}, 60);
  const Bridge bridge =
      made({plate, circle({200, 200, 8}, {0, 0, 1}, 70)}, {other, onBall({200, 200, 200}, 60, {0, 0, -1}, 30)});
  const ModelPoint lid = at(bridge.mesh, static_cast<std::uint32_t>(bridge.mesh.positions.size() - 2));
  CHECK(lid.z > 1);
  CHECK(lid.z < 8);
}

TEST_CASE("a strut between the inner walls of a hollow ball begins and ends in its wall") {
  mesh::TriMesh shell = ball({}, 100, 48);
  const mesh::TriMesh inside = ball({}, 80, 48);
  const auto first = static_cast<std::uint32_t>(shell.positions.size());
  shell.positions.insert(shell.positions.end(), inside.positions.begin(), inside.positions.end());
  for (const auto& [a, b, c] : inside.triangles) shell.triangles.push_back({a + first, c + first, b + first});
  for (const double rim : {8.0, 15.0, 30.0}) {
    CAPTURE(rim);
    const Bridge bridge = made({shell, onBall({}, 80, {1, 0.1, 0}, rim)}, {shell, onBall({}, 80, {-1, 0.1, 0}, rim)});
    CHECK(bridge.rims[0].out.x < -0.9);
    const auto count = static_cast<std::uint32_t>(bridge.mesh.positions.size());
    for (const std::uint32_t lid : {count - 2, count - 1}) {
      CHECK(norm(at(bridge.mesh, lid)) > 80);
      CHECK(norm(at(bridge.mesh, lid)) < 100);
    }
  }
}

TEST_CASE("a handle goes out of a ball and back into it, farther out with a larger bow") {
  const mesh::TriMesh host = ball({}, 80);
  const Points up = onBall({}, 80, {1, 0.6, 0}, 12), down = onBall({}, 80, {1, -0.6, 0}, 12);
  double before = 0;
  for (const double bow : {0.6, 1.0, 1.8}) {
    const Bridge bridge = made({host, up}, {host, down}, {0.8, bow});
    const ModelPoint middle = meanOf(ringOf(bridge, ringsOf(bridge) / 2));
    CHECK(std::abs(middle.y) < 2);
    CHECK(middle.x > before + 5);
    before = middle.x;
  }
  CHECK(before > 110);
}

TEST_CASE("a rim round an arm continues the arm towards the other end") {
  // The rim lies where a ring is cut across: its bridge leaves along the ring.
  const mesh::TriMesh ring = testing::torus(100, 30, 96, 48), other = ball({260, 160, 0}, 60, 48);
  const Points round = circle({100, 0, 0}, {0, 1, 0}, 30);
  const Bridge bridge = made({ring, round}, {other, onBall({260, 160, 0}, 60, {-1, -0.2, 0}, 30)});
  CHECK(bridge.rims[0].out.y > 0.99);
  const ModelPoint first = normalized(meanOf(ringOf(bridge, 3)) - bridge.rims[0].centre);
  CHECK(first.y > 0.9);
}

TEST_CASE(
    "a bridge is the same, whichever way its rims go round and wherever they begin, turned and scaled with its hosts") {
  const ModelPoint a{0, 0, 0}, b{180, 90, 30};
  const mesh::TriMesh one = ball(a, 80), two = ball(b, 70);
  const Points from = onBall(a, 80, {1, 0.2, 0.3}, 30), to = onBall(b, 70, {-1, 0.1, 0}, 25);
  const double volume = mesh::inspect(made({one, from}, {two, to}).mesh).volume;
  Points other(from.rbegin(), from.rend());
  std::ranges::rotate(other, other.begin() + 7);
  CHECK(mesh::inspect(made({one, other}, {two, to}).mesh).volume == doctest::Approx(volume).epsilon(2e-3));
  CHECK(mesh::inspect(made({two, to}, {one, from}).mesh).volume == doctest::Approx(volume).epsilon(2e-3));
  const geometry::Turn turn = geometry::turnAbout(ModelPoint{1, 2, 3}, 0.8);
  const auto turned = [&](mesh::TriMesh mesh) {
    for (auto& p : mesh.positions) {
      const ModelPoint q = geometry::turned(turn, ModelPoint{p[0], p[1], p[2]}) * 2.0;
      p = {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)};
    }
    return mesh;
  };
  const auto turnedLine = [&](Points line) {
    for (ModelPoint& p : line) p = geometry::turned(turn, p) * 2.0;
    return line;
  };
  const mesh::TriMesh oneTurned = turned(one), twoTurned = turned(two);
  const Points fromTurned = turnedLine(from), toTurned = turnedLine(to);
  CHECK(mesh::inspect(made({oneTurned, fromTurned}, {twoTurned, toTurned}).mesh).volume ==
        doctest::Approx(8 * volume).epsilon(2e-3));
}

TEST_CASE("rims that make no bridge are refused, with what") {
  const mesh::TriMesh host = ball({}, 80), none;
  const Points rim = onBall({}, 80, {1, 0, 0}, 20), line{{80, 0, 0}, {80, 10, 0}, {80, 20, 0}};
  const Points far = onBall({}, 80, {-1, 0, 0}, 20);
  CHECK(makeBridge({none, rim}, {host, far}, {}, kPicture).error() == Error::BridgeInvalid);
  CHECK(makeBridge({host, line}, {host, far}, {}, kPicture).error() == Error::BridgeInvalid);
  CHECK(makeBridge({host, rim}, {host, rim}, {}, kPicture).error() == Error::BridgeInvalid);
}

TEST_CASE("random bridges between balls, rings and boxes are lawful, or there is no room for them") {
  int count = 0, refused = 0;
  for (const std::uint64_t seed : testing::seeds(0, 60)) {
    Rng rng(seed);
    const auto direction = [&] {
      return normalized(ModelPoint{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)});
    };
    const auto host = [&](ModelPoint centre) {
      mesh::TriMesh mesh = rng.below(3) == 0   ? testing::torus(60, 25)
                           : rng.below(2) == 0 ? testing::box(90, 70, 80)
                                               : ball({}, 60, 20);
      for (auto& p : mesh.positions) {
        p = {p[0] + static_cast<float>(centre.x), p[1] + static_cast<float>(centre.y),
             p[2] + static_cast<float>(centre.z)};
      }
      return mesh;
    };
    const ModelPoint there = direction() * rng.uniform(180, 400);
    const mesh::TriMesh one = host({}), two = host(there);
    const auto rim = [&](const mesh::TriMesh& mesh, ModelPoint centre) {
      const mesh::SurfacePlaces places(mesh);
      const auto place = places.nearest(centre + direction() * 60);
      return circle(place->at, place->face, rng.uniform(5, 25));
    };
    const Points from = rim(one, {}), to = rim(two, there);
    const Result<Bridge> bridge =
        makeBridge({one, from}, {two, to}, {rng.uniform(0.1, 1), rng.uniform(0.5, 2)}, kPicture);
    ++count;
    CAPTURE(seed);
    if (!bridge) {
      CHECK(bridge.error() == Error::BridgeInvalid);
      ++refused;
      continue;
    }
    CHECK(testing::requireLawful(bridge.value().mesh).genus == 0);
    CHECK_FALSE(mesh::selfCrossing(bridge.value().mesh));
  }
  CHECK(count > 0);
  CHECK(refused <= count / 10);
}
