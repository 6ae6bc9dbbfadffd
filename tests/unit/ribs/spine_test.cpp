#include "engine/ribs/base/spine.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/geometry/polyline.h"
#include "tests/unit/ribs/fixtures.h"

using namespace spineloft;
using namespace spineloft::ribs;
using fixtures::Points;

namespace {

constexpr image::Size kPicture{800, 600};

Points wave(int count) {
  Points p;
  for (int i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / (count - 1);
    p.push_back({100 + 600 * t, 300 + 80 * std::sin(5 * t)});
  }
  return p;
}

double farthest(const Points& a, const Points& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, distance(a[i], b[i]));
  return worst;
}

}  // namespace

TEST_CASE("a clean spine is evenly spaced, keeps its ends and has the asked number of points") {
  const Points stroke = wave(50);
  const auto spine = cleanSpine(stroke, kPicture, {});
  REQUIRE(spine.ok());
  const Points& p = spine.value().points;
  REQUIRE(p.size() == 100);
  CHECK(distance(p.front(), stroke.front()) < 1e-9);
  CHECK(distance(p.back(), stroke.back()) < 1e-9);
  const double step = distance(p[0], p[1]);
  for (std::size_t i = 1; i + 1 < p.size(); ++i) {
    CHECK(distance(p[i], p[i + 1]) == doctest::Approx(step).epsilon(0.02));
  }
}

TEST_CASE("a stroke of 30 samples and one of 3000 give the same spine within a pixel") {
  const auto few = cleanSpine(wave(30), kPicture, {}), many = cleanSpine(wave(3000), kPicture, {});
  REQUIRE(few.ok());
  REQUIRE(many.ok());
  REQUIRE(few.value().points.size() == many.value().points.size());
  CHECK(farthest(few.value().points, many.value().points) < 1);
}

TEST_CASE("a spine cleaned in memory that was used for others is the one from scratch") {
  Rng rng(23);
  SpineMemory memory;
  Spine spine;
  int cleaned = 0;
  for (int round = 0; round < 80; ++round) {
    const std::size_t points = round % 10 == 3 ? 1 : 2 + rng.below(round % 9 == 0 ? 900 : 60);
    const Points stroke = fixtures::wander(rng, points, round % 4 == 0 ? 60 : 5);
    const SpineParams params{.ribs = 2 + static_cast<int>(rng.below(200))};
    const auto fresh = cleanSpine(stroke, kPicture, params);
    const Status status = cleanSpine(stroke, kPicture, params, memory, spine);
    REQUIRE(status.ok() == fresh.ok());
    if (!status.ok()) CHECK(status.error() == fresh.error());
    if (status.ok()) CHECK(spine == fresh.value());
    cleaned += status.ok() ? 1 : 0;
  }
  CHECK(cleaned > 20);
  CHECK(cleaned < 80);
}

TEST_CASE("drawn backwards, a stroke gives exactly the reversed spine") {
  Rng rng(21);
  for (int round = 0; round < 50; ++round) {
    Points stroke = fixtures::wander(rng, 3 + rng.below(60), 5);
    const auto there = cleanSpine(stroke, kPicture, {});
    std::ranges::reverse(stroke);
    const auto back = cleanSpine(stroke, kPicture, {});
    REQUIRE(there.ok() == back.ok());
    if (!there.ok()) continue;
    Points reversed = back.value().points;
    std::ranges::reverse(reversed);
    CHECK(there.value().points == reversed);
  }
}

TEST_CASE("a tremor is smoothed out and the course of the hand is kept") {
  Rng rng(22);
  Points stroke = wave(400);
  for (PicturePoint& p : stroke) p += {rng.uniform(-1.5, 1.5), rng.uniform(-1.5, 1.5)};
  const auto spine = cleanSpine(stroke, kPicture, {}), clean = cleanSpine(wave(400), kPicture, {});
  REQUIRE(spine.ok());
  CHECK(farthest(spine.value().points, clean.value().points) < 3);
  // Turning from segment to segment tells the tremor: away from the ends, which stay where the
  // pen was, it must be near the smooth wave's own.
  double worst = 0;
  const Points& p = spine.value().points;
  for (std::size_t i = 4; i + 4 < p.size(); ++i) {
    worst = std::max(worst, std::abs(cross(normalized(p[i] - p[i - 1]), normalized(p[i + 1] - p[i]))));
  }
  CHECK(worst < 0.1);
}

TEST_CASE("a short stroke gets fewer points than asked, never closer than the smallest spacing") {
  const auto spine = cleanSpine(Points{{100, 100}, {121, 100}}, kPicture, {});
  REQUIRE(spine.ok());
  CHECK(spine.value().points.size() == 11);
}

TEST_CASE("what leaves the picture is clipped and the longest inside run stays") {
  const Points stroke{{-200, 100}, {50, 100}, {50, -80}, {300, -80}, {300, 500}};
  const auto spine = cleanSpine(stroke, kPicture, {});
  REQUIRE(spine.ok());
  for (PicturePoint p : spine.value().points) {
    CHECK(p.x == doctest::Approx(300).epsilon(1e-6));
    CHECK(p.y >= -0.5);
    CHECK(p.y <= 500.001);
  }
}

TEST_CASE("a small hook at the end of the pen's way is dropped, a real loop is refused") {
  Points hook;
  for (int i = 0; i <= 60; ++i) hook.push_back({100 + 8.0 * i, 300});
  for (int i = 1; i <= 20; ++i) {
    const double a = std::numbers::pi * 2 * i / 18 - std::numbers::pi / 2;
    hook.push_back({580 + 8 * std::cos(a), 308 + 8 * std::sin(a)});
  }
  hook.push_back({575, 290});
  const auto spine = cleanSpine(hook, kPicture, {});
  REQUIRE(spine.ok());
  CHECK_FALSE(geometry::findCrossing(spine.value().points).has_value());
  CHECK(distance(spine.value().points.front(), hook.front()) < 1e-9);

  Points loop;
  for (int i = 0; i <= 100; ++i) {
    const double t = i / 100.0;
    loop.push_back(
        {100 + 500 * t + 200 * std::sin(2 * std::numbers::pi * t), 300 - 150 * std::cos(2 * std::numbers::pi * t)});
  }
  for (int i = 0; i <= 40; ++i) loop.push_back({600.0 - 12 * i, 150.0 + 6 * i});
  REQUIRE(geometry::findCrossing(loop).has_value());
  const auto refused = cleanSpine(loop, kPicture, {});
  REQUIRE_FALSE(refused.ok());
  CHECK(refused.error() == Error::StrokeLoops);
}

TEST_CASE("every bad stroke is refused with its own name") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const auto errorOf = [](const Points& p, const SpineParams& params) {
    const auto spine = cleanSpine(p, kPicture, params);
    REQUIRE_FALSE(spine.ok());
    return spine.error();
  };
  CHECK(errorOf({}, {}) == Error::StrokeTooShort);
  CHECK(errorOf({{5, 5}}, {}) == Error::StrokeTooShort);
  CHECK(errorOf({{5, 5}, {5, 5}, {5, 5}}, {}) == Error::StrokeTooShort);
  CHECK(errorOf({{5, 5}, {nan, 7}}, {}) == Error::StrokeNotFinite);
  CHECK(errorOf({{5, 5}, {7, inf}}, {}) == Error::StrokeNotFinite);
  CHECK(errorOf({{-50, 5}, {-10, 300}}, {}) == Error::StrokeOutsidePicture);
  CHECK(errorOf({{5, 5}, {50, 50}}, {.ribs = 1}) == Error::ValueOutOfRange);
  CHECK(errorOf({{5, 5}, {50, 50}}, {.minSpacing = 0}) == Error::ValueOutOfRange);
  CHECK(errorOf({{5, 5}, {50, 50}}, {.smoothness = nan}) == Error::ValueOutOfRange);
}
