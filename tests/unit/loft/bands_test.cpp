#include "engine/loft/bands.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "engine/base/rng.h"
#include "engine/base/vec.h"

using namespace spineloft;
using namespace spineloft::loft;

namespace {

using Points = std::vector<std::array<float, 3>>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

ModelPoint at(const Points& points, std::uint32_t i) { return {points[i][0], points[i][1], points[i][2]}; }

// Two rings of random points, near or far from the origin and each other, one after the other.
Points twoRings(std::size_t count, double size, Rng& rng) {
  const double away = rng.uniform(-1e4, 1e4);
  Points points;
  for (std::size_t i = 0; i < 2 * count; ++i) {
    const auto c = [&] { return static_cast<float>(away + rng.uniform(-size, size)); };
    points.push_back({c(), c(), c()});
  }
  return points;
}

struct Walls {
  Triangles triangles;
  WallTally tally;
};

Walls wallsOf(const Points& points, const std::vector<std::size_t>& sizes) {
  const std::size_t count = points.size() / 2;
  RingPlanes a, b;
  a.read(std::span(points).first(count), sizes);
  b.read(std::span(points).subspan(count), sizes);
  Walls walls{Triangles(2 * count), WallTally(points[0][2])};
  walls.tally.addVertices(a);
  walls.tally.addVertices(b);
  makeWalls({a, b, 0, static_cast<std::uint32_t>(count)}, sizes, walls.triangles.data(), walls.tally);
  return walls;
}

}  // namespace

TEST_CASE(
    "walls between rings of any curves use every edge of a curve once, and cut quads along the shorter diagonal") {
  Rng rng(81);
  for (int round = 0; round < 300; ++round) {
    std::vector<std::size_t> sizes;
    for (std::uint32_t curves = 1 + rng.below(3); curves > 0; --curves) sizes.push_back(3 + rng.below(12));
    const std::size_t count = std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
    const Points points = twoRings(count, rng.uniform(0.1, 300), rng);
    const Walls walls = wallsOf(points, sizes);
    std::size_t first = 0, quad = 0;
    for (const std::size_t size : sizes) {
      for (std::size_t k = 0; k < size; ++k, ++quad) {
        const auto a0 = static_cast<std::uint32_t>(first + k), a1 = static_cast<std::uint32_t>(first + (k + 1) % size);
        const auto n = static_cast<std::uint32_t>(count), b0 = a0 + n, b1 = a1 + n;
        const auto &one = walls.triangles[2 * quad], &two = walls.triangles[2 * quad + 1];
        const bool straight = one[2] == b1;
        CHECK(one == (straight ? std::array{a0, b0, b1} : std::array{a0, b0, a1}));
        CHECK(two == (straight ? std::array{a0, b1, a1} : std::array{a1, b0, b1}));
        const double d0 = distance(at(points, a0), at(points, b1)), d1 = distance(at(points, a1), at(points, b0));
        CHECK((straight ? d0 / d1 : d1 / d0) < 1 + 1e-5);
      }
      first += size;
    }
  }
}

TEST_CASE("what is said of walls in single precision is true") {
  Rng rng(82);
  int certain = 0, sound = 0;
  for (int round = 0; round < 400; ++round) {
    const std::size_t count = 3 + rng.below(40);
    Points points = twoRings(count, rng.uniform(0.1, 300), rng);
    // Every other time one point nearly lies between its neighbours, or on one of them.
    if (round % 2 == 0) {
      const auto t = static_cast<float>(rng.below(2) == 0 ? 0 : rng.uniform(0, 1));
      for (std::size_t axis = 0; axis < 3; ++axis)
        points[1][axis] = points[0][axis] + t * (points[count][axis] - points[0][axis]);
    }
    const Walls walls = wallsOf(points, {count});
    double volume = 0, least = 1e300;
    ModelPoint low = at(points, 0), high = low;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      const ModelPoint p = at(points, i);
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    for (const auto& t : walls.triangles) {
      const ModelPoint a = at(points, t[0]), b = at(points, t[1]), c = at(points, t[2]), n = cross(b - a, c - a);
      volume += n.z * (a.z + b.z + c.z - 3 * static_cast<double>(points[0][2])) / 6;
      least = std::min(least, norm(n) / 2);
    }
    CHECK(walls.tally.bounds() == mesh::Bounds{{low.x, low.y, low.z}, {high.x, high.y, high.z}});
    CHECK(std::abs(walls.tally.volume() - volume) <= walls.tally.volumeError());
    certain += std::abs(volume) > walls.tally.volumeError() ? 1 : 0;
    for (const double area : {1e-6, 1e-3, 1.0, 100.0, 0.4 * least}) {
      if (walls.tally.surelyLarger(area)) CHECK(least > area);
    }
    sound += walls.tally.surelyLarger(0.4 * least) ? 1 : 0;
  }
  CHECK(certain > 300);
  CHECK(sound > 150);
}
