#include "engine/ribs/edit/spine_gestures.h"

#include <doctest/doctest.h>

#include <cmath>

#include "engine/geometry/polyline.h"
#include "tests/unit/ribs/fixtures.h"

using namespace spineloft;
using namespace spineloft::ribs;
using fixtures::Points;

namespace {

double lengthOf(const Points& p) { return geometry::arcLengths(std::span<const PicturePoint>(p)).back(); }
double farFrom(const Points& line, PicturePoint p) {
  double best = 1e9;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const PicturePoint u = line[i + 1] - line[i];
    const double t = std::clamp(dot(p - line[i], u) / std::max(dot(u, u), 1e-12), 0.0, 1.0);
    best = std::min(best, distance(p, line[i] + u * t));
  }
  return best;
}

}  // namespace

TEST_CASE("the bent point goes to its place, and beyond the reach the stroke stays") {
  Rng rng(3);
  for (int round = 0; round < 40; ++round) {
    const Points stroke = fixtures::wander(rng, 2 + rng.below(300), 3);
    const double at = rng.below(5) == 0 ? rng.below(2) : rng.uniform();
    const double reach = rng.below(4) == 0 ? 0 : rng.uniform(0.02, 0.4);
    const PicturePoint to{rng.uniform(0, 800), rng.uniform(0, 800)};
    const Points bent = bendStroke(stroke, at, to, reach);
    REQUIRE(bent.size() >= stroke.size());
    CHECK(farFrom(bent, to) < 1e-9);
    const double spread = std::max(reach, 0.02);
    if (at > spread) CHECK(distance(bent.front(), stroke.front()) < 1e-9);
    if (at < 1 - spread) CHECK(distance(bent.back(), stroke.back()) < 1e-9);
    for (std::size_t i = 0; i < bent.size(); ++i) {
      const double here = static_cast<double>(i) / static_cast<double>(bent.size() - 1);
      if (std::abs(here - at) > spread) CHECK(farFrom(stroke, bent[i]) < 1e-6);
    }
  }
}

TEST_CASE("the end of a stroke is pulled by bending it there") {
  const Points stroke{{10, 10}, {110, 10}};
  const Points bent = bendStroke(stroke, 1, {130, 40}, 0.1);
  CHECK(bent.back() == PicturePoint{130, 40});
  CHECK(bent.front() == PicturePoint{10, 10});
}

TEST_CASE("a shifted stroke shifts back") {
  const Points stroke{{10, 10}, {50, 30}, {110, 10}};
  const Points there = shiftStroke(stroke, {7, -3});
  CHECK(there[1] == PicturePoint{57, 27});
  CHECK(shiftStroke(there, {-7, 3}) == stroke);
}

TEST_CASE("a stroke is drawn out to a point ahead and cut at a point behind, at either end") {
  Rng rng(8);
  for (int round = 0; round < 30; ++round) {
    Points stroke = fixtures::wander(rng, 60, 4);
    for (const bool atStart : {false, true}) {
      const PicturePoint end = atStart ? stroke.front() : stroke.back();
      const PicturePoint in = atStart ? stroke[1] : stroke[stroke.size() - 2];
      const Points longer = extendStroke(stroke, atStart, end + normalized(end - in) * 30);
      CHECK(lengthOf(longer) == doctest::Approx(lengthOf(stroke) + 30));
      CHECK((atStart ? longer.back() : longer.front()) == (atStart ? stroke.back() : stroke.front()));
      const std::size_t cut = atStart ? 15 : 44;
      const Points shorter = extendStroke(stroke, atStart, stroke[cut]);
      CHECK(distance(atStart ? shorter.front() : shorter.back(), stroke[cut]) < 1e-9);
      CHECK(lengthOf(shorter) == doctest::Approx(44 * 4.0).epsilon(1e-6));
      for (const PicturePoint p : shorter) CHECK(farFrom(stroke, p) < 1e-9);
    }
  }
}

TEST_CASE("a cut back to the other end leaves a stroke of two points or more") {
  const Points stroke{{10, 10}, {60, 10}, {110, 10}};
  for (const bool atStart : {false, true}) {
    const Points left = extendStroke(stroke, atStart, {atStart ? 500.0 : -500.0, 10});
    CHECK(left.size() >= 2);
    CHECK(lengthOf(left) > 1);
  }
}

TEST_CASE("points that are not finite change nothing") {
  const Points stroke{{10, 10}, {60, 10}};
  const PicturePoint nowhere{std::nan(""), 0};
  CHECK(bendStroke(stroke, 0.5, nowhere, 0.1) == stroke);
  CHECK(bendStroke(stroke, std::nan(""), {1, 1}, 0.1) == stroke);
  CHECK(extendStroke(stroke, true, nowhere) == stroke);
  CHECK(shiftStroke(stroke, nowhere) == stroke);
}
