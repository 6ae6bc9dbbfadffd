#include "engine/geometry/ridge.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/base/rng.h"

using namespace spineloft;
using namespace spineloft::geometry;

namespace {

/// Distances to all sides, the nearest first.
std::vector<double> toSides(SectionPoint p, const std::vector<SectionPoint>& rim) {
  std::vector<double> found;
  for (std::size_t i = 0, j = rim.size() - 1; i < rim.size(); j = i++) {
    const SectionPoint along = rim[i] - rim[j];
    const double t = std::clamp(dot(p - rim[j], along) / dot(along, along), 0.0, 1.0);
    found.push_back(distance(p, rim[j] + along * t));
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace

TEST_CASE("ridge points are equally far from two sides, or from a corner that points inwards") {
  Rng rng(3);
  for (int round = 0; round < 30; ++round) {
    // A star-shaped polygon, counter-clockwise.
    std::vector<SectionPoint> rim;
    const int count = 5 + int(rng.below(8));
    for (int i = 0; i < count; ++i) {
      const double a = 2 * std::numbers::pi * (i + 0.6 * rng.uniform()) / count, r = rng.uniform(30, 100);
      rim.push_back({r * std::cos(a), r * std::sin(a)});
    }
    const std::vector<std::size_t> sizes{rim.size()};
    const RimDistance distances(rim, sizes);
    const std::vector<double> rows{2, 5, 9};
    const auto points = ridgePoints(rim, sizes, distances, {9, 2, rows});
    CHECK(points.size() > 4);
    for (const SectionPoint p : points) {
      const std::vector<double> away = toSides(p, rim);
      CHECK(away[0] <= 9 * (1 + 1e-2));
      // Both sides of an inward corner are as near as the corner itself.
      CHECK(away[1] - away[0] <= 2e-2 * away[0] + 1e-9);
    }
  }
}

TEST_CASE("a smooth outline that is wide enough has no ridge") {
  std::vector<SectionPoint> rim;
  for (int i = 0; i < 90; ++i) {
    const double a = std::numbers::pi * i / 45;
    rim.push_back({80 * std::cos(a), 50 * std::sin(a)});
  }
  const std::vector<std::size_t> sizes{rim.size()};
  const RimDistance distances(rim, sizes);
  CHECK(ridgePoints(rim, sizes, distances, {10, 2, {}}).empty());
}

TEST_CASE("edges of a mesh come to lie along the ridges of a surface") {
  // A roof over a square: its height is the distance to the rim.
  const std::vector<SectionPoint> rim{{0, 0}, {100, 0}, {100, 100}, {0, 100}};
  const std::vector<std::size_t> sizes{4};
  const RimDistance distances(rim, sizes);
  const auto height = [&](SectionPoint p) { return distances.to(p); };
  PlaneMesh mesh(rim, sizes);
  const std::vector<double> rows;
  for (const SectionPoint p : ridgePoints(rim, sizes, distances, {60, 4, rows})) mesh.insert(p);
  Rng rng(8);
  for (int i = 0; i < 300; ++i) mesh.insert({rng.uniform(1, 99), rng.uniform(1, 99)});
  const auto volume = [&] {
    double sum = 0;
    for (const auto& [a, b, c] : mesh.triangles()) {
      const auto& p = mesh.points();
      sum += cross(p[b] - p[a], p[c] - p[a]) / 2 * (height(p[a]) + height(p[b]) + height(p[c])) / 3;
    }
    return sum;
  };
  const double exact = 100.0 * 100 * 100 / 6, before = std::abs(volume() - exact);
  flipToSurface(mesh, height, 1e9, 1e-3);
  CHECK(std::abs(volume() - exact) < 0.5 * before);
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles()) {
    const double twice = cross(mesh.points()[b] - mesh.points()[a], mesh.points()[c] - mesh.points()[a]);
    CHECK(twice > 0);
    area += twice / 2;
  }
  CHECK(area == doctest::Approx(10000));
}
