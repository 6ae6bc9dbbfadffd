#include "engine/ribs/search/overshoot.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/ribs/fixtures.h"

using namespace spineloft;
using namespace spineloft::ribs;

namespace {

constexpr image::Size kPicture{640, 300};
constexpr double kFrom = 120, kTo = 520, kHalf = 34;

// A round-ended bar along y = 150.
bool inBar(PicturePoint p) {
  const double beyond = std::max({kFrom + kHalf - p.x, p.x - (kTo - kHalf), 0.0});
  return std::hypot(beyond, p.y - 150) <= kHalf;
}
// The same as a line of ink.
bool onOutline(PicturePoint p) {
  const double beyond = std::max({kFrom + kHalf - p.x, p.x - (kTo - kHalf), 0.0});
  return std::abs(std::hypot(beyond, p.y - 150) - kHalf) <= 1.5;
}

const image::EdgeMap& bar() {
  static const image::EdgeMap kMap = fixtures::mapOf(kPicture, inBar);
  return kMap;
}
const image::EdgeMap& drawnBar() {
  static const image::EdgeMap kMap = fixtures::mapOf(kPicture, onOutline);
  return kMap;
}

// Straight, with a little of the tremor of a hand.
fixtures::Points stroke(double from, double to) {
  fixtures::Points points;
  Rng rng(3);
  for (double x = from; x < to; x += 4) points.push_back({x, 150 + rng.uniform(-1, 1)});
  points.push_back({to, 150});
  return points;
}

fixtures::Points cut(const fixtures::Points& drawn, const image::EdgeMap& map) {
  return strokeOnThing(drawn, {map, kPicture}, {}, {});
}

}  // namespace

TEST_CASE("a stroke that was drawn past both ends of a thing ends a little before the thing does") {
  for (const image::EdgeMap* map : {&bar(), &drawnBar()}) {
    for (const double past : {0.5 * kHalf, kHalf, 2 * kHalf}) {
      CAPTURE(map == &bar());
      CAPTURE(past);
      const fixtures::Points kept = cut(stroke(kFrom - past, kTo + past), *map);
      CHECK(kept.front().x > kFrom);
      CHECK(kept.front().x < kFrom + kHalf);
      CHECK(kept.back().x < kTo);
      CHECK(kept.back().x > kTo - kHalf);
    }
  }
}

TEST_CASE("a stroke that lies on a thing is left as it is, to the last point") {
  for (const image::EdgeMap* map : {&bar(), &drawnBar()}) {
    for (const double before : {0.2, 0.6, 1.0, 2.0}) {
      CAPTURE(map == &bar());
      CAPTURE(before);
      const fixtures::Points drawn = stroke(kFrom + before * kHalf, kTo - before * kHalf);
      CHECK(cut(drawn, *map) == drawn);
    }
  }
}

TEST_CASE("only the end that went too far is cut, whichever way the stroke was drawn") {
  const fixtures::Points drawn = stroke(kFrom + kHalf, kTo + kHalf);
  const fixtures::Points kept = cut(drawn, bar());
  CHECK(kept.front() == drawn.front());
  CHECK(kept.back().x < kTo);
  fixtures::Points back(drawn.rbegin(), drawn.rend());
  const fixtures::Points keptBack = cut(back, bar());
  CHECK(keptBack.back() == drawn.front());
  CHECK(distance(keptBack.front(), kept.back()) < 2);
}

TEST_CASE("a stroke of two points is cut as one of many is") {
  const fixtures::Points kept = cut({{kFrom - kHalf, 150}, {kTo + kHalf, 150}}, bar());
  REQUIRE(kept.size() == 2);
  CHECK(kept.front().x > kFrom);
  CHECK(kept.front().x < kFrom + kHalf);
  CHECK(kept.back().x < kTo);
  CHECK(kept.back().x > kTo - kHalf);
}

TEST_CASE("a stroke that was cut is not cut again") {
  const fixtures::Points once = cut(stroke(kFrom - kHalf, kTo + kHalf), bar());
  CHECK(cut(once, bar()) == once);
}

TEST_CASE("where nothing is known of a picture, or there is nothing in it, a stroke stays whole") {
  const fixtures::Points drawn = stroke(kFrom - kHalf, kTo + kHalf);
  CHECK(cut(drawn, {}) == drawn);
  static const image::EdgeMap kNothing = fixtures::mapOf(kPicture, [](PicturePoint) { return false; });
  CHECK(cut(drawn, kNothing) == drawn);
  const fixtures::Points dot{{100, 100}};
  CHECK(cut(dot, bar()) == dot);
}

TEST_CASE("strokes of a thing that go on into another thing of its colour are not cut") {
  // The bar stands on a wall.
  static const image::EdgeMap kStanding =
      fixtures::mapOf(kPicture, [](PicturePoint p) { return inBar(p) || p.x > 470; });
  const fixtures::Points drawn = stroke(kFrom + kHalf, 520);
  CHECK(cut(drawn, kStanding) == drawn);
}
