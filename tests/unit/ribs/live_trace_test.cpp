#include "engine/ribs/search/live_trace.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/base/rng.h"
#include "engine/base/shared_loop.h"
#include "engine/ribs/evidence/ignored.h"
#include "engine/ribs/search/ribs.h"
#include "tests/support/scarce_memory.h"
#include "tests/unit/ribs/fixtures.h"

using namespace spineloft;
using namespace spineloft::ribs;

namespace {

constexpr image::Size kPicture{600, 400};

double middleAt(double x) { return 200 + 50 * std::sin(0.012 * x); }

/// A bent thing that gets broader, with a hollow on one side.
const image::EdgeMap& thing() {
  static const image::EdgeMap kMap = fixtures::mapOf(kPicture, [](PicturePoint p) {
    const double away = p.y - middleAt(p.x), half = 24 + 0.04 * p.x;
    const double hollow = 9 * std::exp(-std::pow((p.x - 330) / 20, 2));
    return p.x > 40 && p.x < 560 && away > -half && away < half - hollow;
  });
  return kMap;
}

/// From x = 60 to there, drawn by a hand that shakes a little.
Spine spineTo(double to, double shift = 0) {
  Rng rng(7);
  fixtures::Points stroke;
  for (double x = 60; x <= to; x += 3) stroke.push_back({x, middleAt(x) + shift + rng.uniform(-1.5, 1.5)});
  return cleanSpine(stroke, kPicture, {}).value();
}

/// Mean distance of the rib ends, as a share of the width.
double apart(const RibSet& a, const RibSet& b) {
  REQUIRE(a.ribs.size() == b.ribs.size());
  double sum = 0;
  for (std::size_t i = 0; i < a.ribs.size(); ++i) {
    const double width = distance(a.ribs[i].left, a.ribs[i].right);
    sum += (distance(a.ribs[i].left, b.ribs[i].left) + distance(a.ribs[i].right, b.ribs[i].right)) / width;
  }
  return sum / (2 * static_cast<double>(a.ribs.size()));
}

RibSet whole(const Spine& spine) { return traceRibs(spine, {thing(), kPicture}, {}, Progress()).value(); }

LiveTrace::Ribs moved(LiveTrace& live, const Spine& spine) { return live.move(spine, {thing(), kPicture}, {}).value(); }

}  // namespace

TEST_CASE("ribs are equal whether or not the loops that find them are shared by two processors") {
  const Spine spine = spineTo(400);
  const RibSet shared = whole(spine);
  int equal = 0;
  for (int again = 0; again < 5; ++again) {
    // Within a share there is nobody to share with.
    sharedLoop(1, [&](LoopShare share) { equal += share.end > share.first && whole(spine) == shared ? 1 : 0; });
  }
  CHECK(equal == 5);
}

TEST_CASE(
    "ribs under the pen are within five hundredths of the width of those of a whole trace, two and a half on the "
    "mean") {
  LiveTrace live;
  int moves = 0;
  double sum = 0;
  for (double to = 90; to <= 330; to += 5) {
    CAPTURE(to);
    const Spine spine = spineTo(to);
    const LiveTrace::Ribs found = moved(live, spine);
    CHECK_FALSE(found.exact);
    const double away = apart(whole(spine), found.set);
    CHECK(away < 0.05);
    sum += away;
    ++moves;
    for (const Rib& rib : found.set.ribs) {
      for (const PicturePoint p : {rib.left, rib.right}) {
        CHECK(isFinite(p));
        CHECK(p.x >= -0.5);
        CHECK(p.y >= -0.5);
        CHECK(p.x <= kPicture.width - 0.5);
        CHECK(p.y <= kPicture.height - 0.5);
      }
    }
  }
  CHECK(sum < 0.025 * moves);
}

TEST_CASE("equal moves give equal ribs, whatever was drawn before") {
  LiveTrace fresh, used;
  for (double to = 540; to >= 90; to -= 50) moved(used, spineTo(to, 12));
  for (double to = 80; to <= 400; to += 20) {
    const LiveTrace::Ribs a = moved(fresh, spineTo(to)), b = moved(used, spineTo(to));
    CHECK(a.exact == b.exact);
    CHECK(a.set == b.set);
  }
}

TEST_CASE("where nothing is known of the picture, ribs under the pen are those of a whole trace") {
  LiveTrace live;
  const PictureEvidence nothing{image::EdgeMap{}, kPicture};
  const LiveTrace::Ribs found = live.move(spineTo(300), nothing, {}).value();
  CHECK(found.exact);
  CHECK(found.set == traceRibs(spineTo(300), nothing, {}, Progress()).value());
}

TEST_CASE("a live trace refuses what a whole trace refuses") {
  LiveTrace live;
  RibParams wrong;
  wrong.levels = 3;
  CHECK(live.move(spineTo(400), {thing(), kPicture}, wrong).error() == Error::ValueOutOfRange);
  CHECK(live.move({{{1, 1}}}, {thing(), kPicture}, {}).error() == Error::StrokeTooShort);
  moved(live, spineTo(400));
  CHECK(live.move({{{1, 1}}}, {thing(), kPicture}, {}).error() == Error::StrokeTooShort);
}

TEST_CASE("a pen whose stroke was followed before asks for no memory but its result's") {
  LiveTrace live;
  const auto drawn = [&](double to) {
    const Spine spine = spineTo(to);
    const std::size_t before = testing::allocatedBytes();
    const LiveTrace::Ribs found = moved(live, spine);
    const std::size_t asked = testing::allocatedBytes() - before;
    const std::size_t result =
        found.set.ribs.size() * sizeof(Rib) +
        (found.set.startFan.points.size() + found.set.endFan.points.size()) * sizeof(PicturePoint);
    return static_cast<double>(asked) / static_cast<double>(result);
  };
  for (int round = 0; round < 2; ++round) {
    for (double to = 90; to <= 540; to += 18) drawn(to);
  }
  for (double to = 90; to <= 540; to += 18) {
    CAPTURE(to);
    CHECK(drawn(to) < 1.05);
  }
}
