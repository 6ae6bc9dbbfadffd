#include "engine/geometry/polygon.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/base/rng.h"
#include "engine/geometry/triangulate.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::geometry;

namespace {

using Points = std::vector<SectionPoint>;

std::span<const SectionPoint> view(const Points& points) { return points; }

/// A star-shaped polygon with random radii; every third side is cut by extra points on it.
Points randomPolygon(Rng& rng) {
  const int corners = 3 + static_cast<int>(rng.below(40));
  Points points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 6.283185307179586 * i / corners, radius = rng.uniform(0.2, 1);
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    if (i > 0 && rng.below(3) == 0) {
      const SectionPoint b = points.back();
      const SectionPoint a = points[points.size() - 2];
      points.pop_back();
      for (const double t : {0.25, 0.5, 0.75}) points.push_back(lerp(a, b, t));
      points.push_back(b);
    }
  }
  return points;
}

bool simpleBySearch(const Points& p) {
  const std::size_t n = p.size();
  const auto side = [](SectionPoint a, SectionPoint b, SectionPoint c) { return cross(b - a, c - a); };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      const SectionPoint a = p[i], b = p[i + 1], c = p[j], d = p[(j + 1) % n];
      if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("triangles fill a polygon: all corners used, none flat, areas add up") {
  Rng rng(3);
  for (int round = 0; round < testing::rounds(400); ++round) {
    Points points = randomPolygon(rng);
    const double area = signedArea(view(points));
    if (!isSimple(points) || area <= 0) continue;
    const auto triangles = triangulate(points);
    REQUIRE(triangles.size() == points.size() - 2);
    double sum = 0;
    std::vector<bool> used(points.size(), false);
    for (const auto& [a, b, c] : triangles) {
      const double part = cross(points[b] - points[a], points[c] - points[a]) / 2;
      CHECK(part > 0);
      sum += part;
      used[a] = used[b] = used[c] = true;
    }
    CHECK(sum == doctest::Approx(area).epsilon(1e-12));
    CHECK(std::all_of(used.begin(), used.end(), [](bool u) { return u; }));
  }
}

TEST_CASE("straight stretches, spirals and combs are filled without flat triangles") {
  Points square;
  for (int side = 0; side < 4; ++side) {
    const SectionPoint corner[] = {{1, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
    for (int i = 0; i < 32; ++i) square.push_back(lerp(corner[side], corner[side + 1], i / 32.0));
  }
  CHECK(triangulate(square).size() == square.size() - 2);
  Points comb = {{-1, -1}, {1, -1}};
  for (int tooth = 10; tooth >= -10; --tooth) {
    comb.push_back({tooth / 10.0, tooth % 2 == 0 ? 1.0 : -0.9});
  }
  CHECK(triangulate(comb).size() == comb.size() - 2);
  CHECK(triangulate(Points{{0, 0}, {1, 0}}).empty());
  CHECK(triangulate(Points{{0, 0}, {1, 0}, {2, 0}}).empty());
  CHECK(triangulate(Points{{0, 0}, {0, 1}, {1, 0}}).empty());
}

TEST_CASE("simplicity agrees with a search over all pairs of edges") {
  Rng rng(4);
  int simple = 0, crossing = 0;
  for (int round = 0; round < testing::rounds(2000); ++round) {
    Points points;
    const int corners = 3 + static_cast<int>(rng.below(6));
    for (int i = 0; i < corners; ++i) points.push_back({rng.uniform(-1, 1), rng.uniform(-1, 1)});
    const bool expected = simpleBySearch(points);
    CHECK(isSimple(points) == expected);
    (expected ? simple : crossing) += 1;
  }
  CHECK(simple > 200);
  CHECK(crossing > 200);
  CHECK_FALSE(isSimple(Points{{0, 0}, {1, 0}, {1, 0}, {0, 1}}));
  CHECK_FALSE(isSimple(Points{{0, 0}, {2, 0}, {1, 0}}));
  CHECK_FALSE(isSimple(Points{{0, 0}, {1, 0}}));
}

TEST_CASE("area, centre and sight of a shape with a known answer") {
  const Points ell = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  CHECK(signedArea(view(ell)) == doctest::Approx(3));
  CHECK(centroid(ell).x == doctest::Approx(5.0 / 6));
  CHECK(centroid(ell).y == doctest::Approx(5.0 / 6));
  CHECK(seesAllEdges(ell, {0.5, 0.5}, 0.4));
  CHECK_FALSE(seesAllEdges(ell, {0.5, 0.5}, 0.6));
  CHECK_FALSE(seesAllEdges(ell, {1.5, 0.5}, 0));
  Points clockwise(ell.rbegin(), ell.rend());
  CHECK(signedArea(view(clockwise)) == doctest::Approx(-3));
  CHECK_FALSE(seesAllEdges(clockwise, {0.5, 0.5}, 0));
}

namespace {

/// A star-shaped polygon with clockwise star-shaped holes in it, one after the other.
struct Pierced {
  Points points;
  std::vector<std::size_t> sizes;
};
Pierced randomPierced(Rng& rng) {
  Pierced shape;
  const auto ring = [&](SectionPoint centre, double low, double high, bool clockwise) {
    const int corners = 3 + static_cast<int>(rng.below(24));
    Points part;
    for (int i = 0; i < corners; ++i) {
      const double angle = 6.283185307179586 * i / corners, radius = rng.uniform(low, high);
      part.push_back(centre + SectionPoint{radius * std::cos(angle), radius * std::sin(angle)});
    }
    if (clockwise) std::reverse(part.begin(), part.end());
    shape.points.insert(shape.points.end(), part.begin(), part.end());
    shape.sizes.push_back(part.size());
  };
  const int holes = static_cast<int>(rng.below(6));
  const bool square = rng.below(2) == 0;
  if (square) {  // many corners in one line
    for (const SectionPoint p : {SectionPoint{-3, -3}, {0, -3}, {3, -3}, {3, 0}, {3, 3}, {0, 3}, {-3, 3}, {-3, 0}}) {
      shape.points.push_back(p);
    }
    shape.sizes.push_back(8);
  } else {
    ring({0, 0}, 5, 9, false);
  }
  for (int i = 0; i < holes; ++i) {
    const double angle = 6.283185307179586 * i / 6;
    const SectionPoint centre{1.8 * std::cos(angle), 1.8 * std::sin(angle)};
    if (square && i % 2 == 0) {  // holes in one line with each other and the square's corners
      for (const SectionPoint p : {SectionPoint{-.5, -.5}, {-.5, .5}, {.5, .5}, {.5, -.5}}) {
        shape.points.push_back(centre + p);
      }
      shape.sizes.push_back(4);
    } else {
      ring(centre, 0.2, 0.8, true);
    }
  }
  return shape;
}

}  // namespace

TEST_CASE("triangles fill polygons with holes and several pieces: all corners used, areas add up") {
  Rng rng(31);
  int pierced = 0;
  for (int round = 0; round < testing::rounds(600); ++round) {
    Pierced shape = randomPierced(rng);
    if (round % 5 == 0) {  // a second piece far away
      for (const SectionPoint p : {SectionPoint{20, 0}, {21, 0}, {20, 1}}) shape.points.push_back(p);
      shape.sizes.push_back(3);
    }
    if (!areSimple(shape.points, shape.sizes)) continue;
    const bool inside = holds(view(shape.points).first(shape.sizes[0]), {1.8, 0});
    if (!inside) continue;
    CAPTURE(round);
    double area = 0;
    std::size_t first = 0, holes = 0, outers = 0;
    for (const std::size_t size : shape.sizes) {
      const double part = signedArea(view(shape.points).subspan(first, size));
      area += part;
      (part > 0 ? outers : holes) += 1;
      first += size;
    }
    pierced += holes > 1;
    const auto triangles = triangulate(view(shape.points), shape.sizes);
    REQUIRE(triangles.size() == shape.points.size() + 2 * holes - 2 * outers);
    double sum = 0;
    std::vector<bool> used(shape.points.size(), false);
    for (const auto& [a, b, c] : triangles) {
      const double part = cross(shape.points[b] - shape.points[a], shape.points[c] - shape.points[a]) / 2;
      CHECK(part > 0);
      sum += part;
      used[a] = used[b] = used[c] = true;
    }
    CHECK(sum == doctest::Approx(area).epsilon(1e-12));
    CHECK(std::all_of(used.begin(), used.end(), [](bool u) { return u; }));
  }
  CHECK(pierced > 150);
}

TEST_CASE("holes whose corners lie on common lines, up to rounding, are filled: no bridge passes through a corner") {
  for (int seed = 0; seed < testing::rounds(300); ++seed) {
    CAPTURE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const double angle = rng.uniform(0, 6.283185307179586), step = rng.uniform(0.1, 30);
    const SectionPoint shift{rng.uniform(-100, 100), rng.uniform(-100, 100)};
    const SectionPoint along{step * std::cos(angle), step * std::sin(angle)}, up{-along.y, along.x};
    const auto at = [&](double x, double y) { return along * x + up * y + shift; };
    Points points{at(0, 0), at(9, 0), at(9, 9), at(0, 9)};
    std::vector<std::size_t> sizes{4};
    double area = 81 * step * step;
    for (int y = 1; y < 9; y += 2) {
      for (int x = 1; x < 9; x += 2) {
        if (rng.below(3) == 0) continue;
        const bool isTriangle = rng.below(2) == 0;
        points.insert(points.end(), {at(x, y), at(x, y + 1), at(x + 1, y + 1)});
        if (!isTriangle) points.push_back(at(x + 1, y));
        sizes.push_back(isTriangle ? 3 : 4);
        area -= (isTriangle ? 0.5 : 1) * step * step;
      }
    }
    const auto triangles = triangulate(points, sizes);
    CHECK(triangles.size() == points.size() + 2 * (sizes.size() - 1) - 2);
    double filled = 0;
    for (const auto& [a, b, c] : triangles) filled += cross(points[b] - points[a], points[c] - points[a]) / 2;
    CHECK(filled == doctest::Approx(area).epsilon(1e-9));
  }
}

TEST_CASE("the centre of the kernel sees every edge, and a spiral has none") {
  Rng rng(32);
  for (int round = 0; round < testing::rounds(300); ++round) {
    const Points points = randomPolygon(rng);  // star-shaped from the origin
    const auto centre = kernelCentre(points);
    REQUIRE(centre.has_value());
    CHECK(seesAllEdges(points, *centre, -1e-9));
  }
  const Points spiral = {{-1, -1},   {1, -1},     {1, 1},      {-0.6, 1},  {-0.6, -0.2}, {0.2, -0.2},
                         {0.2, 0.2}, {-0.2, 0.2}, {-0.2, 0.6}, {0.6, 0.6}, {0.6, -0.6},  {-1, -0.6}};
  CHECK(isSimple(spiral));
  CHECK_FALSE(kernelCentre(spiral).has_value());
}

TEST_CASE("polygons that touch each other are not simple together") {
  const Points far = {{0, 0}, {1, 0}, {0, 1}, {2, 2}, {3, 2}, {2, 3}};
  const std::array<std::size_t, 2> sizes = {3, 3};
  CHECK(areSimple(far, sizes));
  Points touching = far;
  touching[3] = {0.5, 0.5};
  CHECK_FALSE(areSimple(touching, sizes));
  CHECK(holds(view(far).first(3), {0.2, 0.2}));
  CHECK_FALSE(holds(view(far).first(3), {0.8, 0.8}));
}
