#include "engine/mesh/self_crossing.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "engine/base/rng.h"
#include "tests/support/test_files.h"

using namespace spineloft;
using mesh::TriMesh;

namespace {

using Point = std::array<double, 3>;

/// A cube of side 1 with its low corner there.
void addCube(TriMesh& mesh, const std::array<float, 3>& low) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::uint32_t v = 0; v < 8; ++v) {
    mesh.positions.push_back({low[0] + static_cast<float>(v & 1), low[1] + static_cast<float>((v >> 1) & 1),
                              low[2] + static_cast<float>(v >> 2)});
  }
  for (const auto& [a, b, c, d] : {std::array{0u, 2u, 3u, 1u},
                                   {4u, 5u, 7u, 6u},
                                   {0u, 1u, 5u, 4u},
                                   {2u, 6u, 7u, 3u},
                                   {0u, 4u, 6u, 2u},
                                   {1u, 3u, 7u, 5u}}) {
    mesh.triangles.push_back({first + a, first + b, first + c});
    mesh.triangles.push_back({first + a, first + c, first + d});
  }
}

double volume(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto from = [&](const Point& p) { return Point{p[0] - a[0], p[1] - a[1], p[2] - a[2]}; };
  const Point u = from(b), v = from(c), w = from(d);
  return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
}

/// Whether the line from d to e goes through the triangle: by the signs of volumes.
bool pierces(const std::array<Point, 3>& t, const Point& d, const Point& e) {
  if (volume(t[0], t[1], t[2], d) * volume(t[0], t[1], t[2], e) > 0) return false;
  const double x = volume(d, e, t[0], t[1]), y = volume(d, e, t[1], t[2]), z = volume(d, e, t[2], t[0]);
  return (x > 0 && y > 0 && z > 0) || (x < 0 && y < 0 && z < 0);
}

std::array<Point, 3> corners(const TriMesh& mesh, std::size_t t) {
  std::array<Point, 3> out;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto& p = mesh.positions[mesh.triangles[t][c]];
    out[c] = {p[0], p[1], p[2]};
  }
  return out;
}

/// Any two triangles, of which none share a corner, by trying every edge against every triangle.
bool crossesByTrying(const TriMesh& mesh) {
  for (std::size_t s = 0; s < mesh.triangles.size(); ++s) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (s == t) continue;
      const auto one = corners(mesh, s), other = corners(mesh, t);
      for (std::size_t k = 0; k < 3; ++k) {
        if (pierces(one, other[k], other[(k + 1) % 3])) return true;
      }
    }
  }
  return false;
}

/// The numbers of tests/browser/support/lofts.mjs, 0…1.
class Seeded {
 public:
  explicit Seeded(std::uint32_t seed) : state_(seed) {}
  double operator()() {
    state_ = state_ * 1664525u + 1013904223u;
    return state_ / 4294967296.0;
  }

 private:
  std::uint32_t state_;
};

void add(TriMesh& mesh, const Point& p) {
  mesh.positions.push_back({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
}

/// As tests/browser/support/crossing_scenes.mjs has them: six triangles anywhere.
TriMesh soup(Seeded& random) {
  TriMesh mesh;
  for (std::uint32_t t = 0; t < 6; ++t) {
    Point centre;
    for (double& x : centre) x = random();
    for (int c = 0; c < 3; ++c) {
      Point p;
      for (std::size_t k = 0; k < 3; ++k) p[k] = centre[k] + 0.6 * random();
      add(mesh, p);
    }
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return mesh;
}

/// The same: two boxes askew, one of which stands a little into the other or is as far away.
TriMesh boxes(Seeded& random) {
  std::array<Point, 3> axes;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t j = 0; j < 3; ++j) axes[k][j] = j == k ? 1 : 0.3 * (random() - 0.5);
  }
  const double sign = random() < 0.25 ? -1 : 1;
  const double size = std::pow(10.0, -(4 + std::floor(5 * random())));
  const double depth = sign * size * (1 + random());
  Point second{1 - depth, 0, 0};
  second[1] = 0.2 * random();
  second[2] = 0.2 * random();
  TriMesh mesh;
  for (const Point& low : {Point{0, 0, 0}, second}) {
    TriMesh cube;
    addCube(cube, {0, 0, 0});
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const auto& v : cube.positions) {
      const Point at{low[0] + v[0], low[1] + v[1], low[2] + v[2]};
      Point p;
      for (std::size_t k = 0; k < 3; ++k) p[k] = at[0] * axes[0][k] + at[1] * axes[1][k] + at[2] * axes[2][k];
      add(mesh, p);
    }
    for (const auto& [a, b, c] : cube.triangles) mesh.triangles.push_back({first + a, first + b, first + c});
  }
  return mesh;
}

}  // namespace

TEST_CASE("the answers are those of trying every pair") {
  const auto bytes = testing::testFile("golden/crossing_verdicts.txt");
  std::string verdicts(bytes.begin(), bytes.end());
  std::erase(verdicts, '\n');
  REQUIRE(verdicts.size() == 240);
  for (std::uint32_t i = 0; i < verdicts.size(); ++i) {
    Seeded random(2654435761u * (i + 1));
    const TriMesh mesh = i < 120 ? soup(random) : boxes(random);
    CAPTURE(i);
    if (verdicts[i] != '?') CHECK(mesh::selfCrossing(mesh).has_value() == (verdicts[i] == '1'));
  }
}

TEST_CASE(
    "a body alone, and two that are apart or only touch, do not cross; two that reach into one another do, there") {
  TriMesh one;
  addCube(one, {0, 0, 0});
  CHECK_FALSE(mesh::selfCrossing(one));
  CHECK_FALSE(mesh::selfCrossing({}));
  const auto with = [&](float x) {
    TriMesh two = one;
    addCube(two, {x, 0.3f, 0.4f});
    return mesh::selfCrossing(two);
  };
  CHECK_FALSE(with(1.5f));
  CHECK_FALSE(with(1));
  // The diagonal is about 3: what is less deep than three millionths is rounding, what is clearly deeper is not.
  CHECK_FALSE(with(1 - 1e-6f));
  CHECK(with(1 - 1e-5f));
  const auto at = with(0.5f);
  REQUIRE(at);
  for (const double x : *at) {
    CHECK(x > 0);
    CHECK(x < 1.5);
  }
}

TEST_CASE("triangles anywhere cross exactly when an edge of one goes through another") {
  Rng rng(7);
  int crossing = 0;
  constexpr int kRounds = 400;
  for (int round = 0; round < kRounds; ++round) {
    TriMesh soup;
    const std::uint32_t count = round % 2 == 0 ? 2 : 24;
    const double size = count == 2 ? 1 : 0.12;
    for (std::uint32_t t = 0; t < count; ++t) {
      const Point centre{rng.uniform(), rng.uniform(), rng.uniform()};
      for (int c = 0; c < 3; ++c) {
        soup.positions.push_back({static_cast<float>(centre[0] + size * rng.uniform()),
                                  static_cast<float>(centre[1] + size * rng.uniform()),
                                  static_cast<float>(centre[2] + size * rng.uniform())});
      }
      soup.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    const bool crosses = crossesByTrying(soup);
    crossing += crosses ? 1 : 0;
    CAPTURE(round);
    CHECK(mesh::selfCrossing(soup).has_value() == crosses);
  }
  // Both happen often.
  CHECK(crossing > kRounds / 20);
  CHECK(crossing < kRounds * 19 / 20);
}
