#include "engine/ribs/search/end_search.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/ribs/search/ribs.h"
#include "tests/unit/ribs/fixtures.h"

using namespace spineloft;
using namespace spineloft::ribs;

namespace {

constexpr image::Size kPicture{400, 440};
constexpr double kTop = 60, kBottom = 340, kLeft = 100, kRight = 300, kGap = 12;

bool near(double a, double b) { return std::abs(a - b) <= 1.5; }

// A box in ink: its bottom stops short of the left wall, which runs on below it.
bool ink(PicturePoint p) {
  if (near(p.x, kLeft)) return p.y >= kTop && p.y <= kBottom + 25;
  if (near(p.x, kRight)) return p.y >= kTop && p.y <= kBottom;
  return (near(p.y, kTop) && p.x >= kLeft && p.x <= kRight) ||
         (near(p.y, kBottom) && p.x >= kLeft + kGap && p.x <= kRight);
}

RibSet traced(const fixtures::Points& stroke, const std::function<bool(PicturePoint)>& inside) {
  const auto map = fixtures::mapOf(kPicture, inside);
  const Spine spine = cleanSpine(stroke, kPicture, {}).value();
  return traceRibs(spine, map, kPicture, {}, Progress()).value();
}

// The least and the greatest y of all ends of ribs and fans.
std::pair<double, double> extentOf(const RibSet& set) {
  double least = kPicture.height, most = 0;
  const auto take = [&](PicturePoint p) {
    least = std::min(least, p.y);
    most = std::max(most, p.y);
  };
  for (const Rib& rib : set.ribs) {
    take(rib.left);
    take(rib.right);
  }
  for (const EndFan* fan : {&set.startFan, &set.endFan}) std::ranges::for_each(fan->points, take);
  return {least, most};
}

bool isBox(const RibSet& set) {
  const auto [least, most] = extentOf(set);
  return std::abs(least - kTop) < kGap && std::abs(most - kBottom) < kGap;
}

}  // namespace

TEST_CASE("a part ends at the line that closes a wide thing close beyond the stroke, though a corner is open") {
  // By how much the stroke stops before the bottom, and how far it is off the middle.
  for (const double before : {15.0, 30.0, 60.0}) {
    for (const double off : {-40.0, 0.0, 40.0}) {
      CAPTURE(before);
      CAPTURE(off);
      const double x = (kLeft + kRight) / 2 + off;
      CHECK(isBox(traced({{x, kTop + 40}, {x, kBottom - before}}, ink)));
    }
  }
}

TEST_CASE("an end is found alike at the start and at the end of a stroke, and mirrored") {
  for (const bool back : {false, true}) {
    for (const bool mirrored : {false, true}) {
      fixtures::Points stroke{{200, kTop + 40}, {200, kBottom - 30}};
      if (back) std::reverse(stroke.begin(), stroke.end());
      const auto inside = [&](PicturePoint p) { return ink({mirrored ? kPicture.width - p.x : p.x, p.y}); };
      CHECK(isBox(traced(stroke, inside)));
    }
  }
}

TEST_CASE("ribs that are moved to an end still reach from the spine to a place on their curve, in order") {
  const RibSet set = traced({{200, kTop + 40}, {200, kBottom - 30}}, ink);
  double before = -1e9;
  for (const Rib& rib : set.ribs) {
    // No two ribs of a straight stroke cross: their ends follow one another down the wall, or along the top and bottom.
    const bool onWall = rib.left.y > kTop + 8 && rib.left.y < kBottom - 8;
    if (onWall) {
      CHECK(rib.left.y > before - 1);
      before = rib.left.y;
    }
    CHECK(rib.leftLevel > 0);
    CHECK(rib.rightLevel > 0);
  }
}
