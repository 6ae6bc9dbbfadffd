#include "engine/geometry/steady.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/base/rng.h"
#include "engine/geometry/polygon.h"
#include "tests/support/outlines.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::geometry;
using namespace spineloft::testing;

namespace {

/// A ring of whole pixels, as a hand or a mask leaves it: each point off by up to a pixel.
std::vector<PicturePoint> tremble(double radius, int count, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<PicturePoint> out;
  for (int i = 0; i < count; ++i) {
    const double a = 2 * std::numbers::pi * i / count, r = radius + rng.uniform(-0.5, 0.5);
    const PicturePoint p{std::round(200 + r * std::cos(a)), std::round(200 + r * std::sin(a))};
    if (out.empty() || distance(out.back(), p) > 0.5) out.push_back(p);
  }
  return out;
}

/// How far the sides lean against the circle, radians, the mean by length.
double lean(const std::vector<PicturePoint>& ring) {
  double sum = 0, length = 0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const PicturePoint side = ring[i] - ring[j], out = (ring[i] + ring[j]) / 2 - PicturePoint{200, 200};
    sum += std::abs(std::atan2(dot(side, out), std::abs(cross(side, out)))) * norm(side);
    length += norm(side);
  }
  return sum / length;
}

double toOutline(PicturePoint p, const std::vector<PicturePoint>& outline) {
  double nearest = INFINITY;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const PicturePoint along = outline[i] - outline[j];
    const double t = std::clamp(dot(p - outline[j], along) / dot(along, along), 0.0, 1.0);
    nearest = std::min(nearest, distance(p, outline[j] + along * t));
  }
  return nearest;
}

}  // namespace

TEST_CASE("the tremor of a hand and the steps of pixels are evened out, by less than asked") {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    const auto clean = cleanRegion({tremble(90, 300, seed)}, 0, {400, 400});
    REQUIRE(clean.ok());
    const Contours even = steadied(clean.value(), {8, 1});
    REQUIRE(even.size() == 1);
    CHECK(lean(even[0]) < 0.35 * lean(clean.value()[0]));
    for (const PicturePoint p : even[0]) {
      REQUIRE(toOutline(p, clean.value()[0]) <= 1 + 1e-9);
      REQUIRE(std::abs(distance(p, {200, 200}) - 90) <= 1.3);
    }
    CHECK(areaOf(even) == doctest::Approx(std::numbers::pi * 90 * 90).epsilon(5e-3));
  }
}

TEST_CASE("polygons keep their corners and their straight sides") {
  const Contours drawn{
      rectangle(50, 60, 320, 240), rectangle(120, 100, 200, 180), {{340, 100}, {390, 300}, {330, 380}}};
  const auto clean = cleanRegion(drawn, 0, {400, 400});
  REQUIRE(clean.ok());
  const Contours even = steadied(clean.value(), {6, 1});
  REQUIRE(even.size() == clean.value().size());
  CHECK(areaOf(even) == doctest::Approx(areaOf(clean.value())).epsilon(1e-9));
  for (std::size_t i = 0; i < even.size(); ++i) {
    for (const PicturePoint corner : clean.value()[i]) {
      CHECK(std::ranges::any_of(even[i], [&](PicturePoint p) { return distance(p, corner) < 1e-9; }));
    }
    for (const PicturePoint p : even[i]) CHECK(toOutline(p, clean.value()[i]) < 1e-9);
  }
}

TEST_CASE("what is steadied is still a region, however it was drawn" * doctest::test_suite("slow")) {
  Rng rng(12);
  for (int round = 0; round < testing::rounds(15); ++round) {
    std::vector<PicturePoint> scribble;
    const int count = 4 + int(rng.below(40));
    for (int i = 0; i < count; ++i) scribble.push_back({rng.uniform(5, 395), rng.uniform(5, 395)});
    const auto clean = cleanRegion({scribble}, round % 3 == 0 ? rng.uniform(3, 20) : 0, {400, 400});
    if (!clean.ok()) continue;
    const double reach = rng.uniform(0.5, 30), most = rng.uniform(0.1, 4);
    const Contours even = steadied(clean.value(), {reach, most});
    REQUIRE(even.size() == clean.value().size());
    const PlaneRegion region = planeRegion(even);
    CHECK(areSimple(region.points, region.sizes));
    for (std::size_t i = 0; i < even.size(); ++i) {
      for (const PicturePoint p : even[i]) REQUIRE(toOutline(p, clean.value()[i]) <= most + 1e-9);
    }
  }
}
