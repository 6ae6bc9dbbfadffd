#include "engine/cli/score.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/rng.h"

using namespace spineloft;
using namespace spineloft::cli;

namespace {

/// An upright bar, 20 px wide and 120 px tall, centred at x = 50, between y = 20 and y = 139.
image::Mask bar(double centre = 50, double half = 10) {
  image::Mask mask{100, 160, std::vector<std::uint8_t>(16000)};
  for (int y = 20; y < 140; ++y) {
    for (int x = 0; x < 100; ++x) {
      if (std::abs(x - centre) < half) mask.pixels[static_cast<std::size_t>(y * 100 + x)] = 255;
    }
  }
  return mask;
}

const std::vector<std::array<double, 3>> kAxis{{49.5, 20, 20}, {49.5, 80, 20}, {49.5, 139, 20}};
const std::vector<PicturePoint> kStroke{{49.5, 40}, {49.5, 120}};

std::vector<PicturePoint> endsAt(double left, double right) {
  std::vector<PicturePoint> ends;
  for (double y = 40; y <= 120; y += 4) ends.insert(ends.end(), {{left, y}, {right, y}});
  return ends;
}

/// 20 columns, 40…59: the bar's half-coverage outline is at 39.5 and 59.5.
image::Mask truthMask() { return bar(49.5, 10); }
Truth truthOfBar() { return Truth({truthMask(), kAxis, 1.0}); }

}  // namespace

TEST_CASE("the truth scores 1 against itself, and its own outline has no rib error to speak of") {
  const Truth truth = truthOfBar();
  const Score score = scorePart(truth, truthMask(), kStroke, endsAt(39.5, 59.5));
  CHECK(score.iou == 1);
  CHECK(score.iouBody == 1);
  CHECK(score.precision == 1);
  CHECK(score.recall == 1);
  REQUIRE(score.ribs.has_value());
  CHECK(score.ribs->count == 42);
  CHECK(score.ribs->meanPx < 0.34);
  CHECK(score.ribs->withinTolerance == 1);
}

TEST_CASE("nothing scores 0 and has no rib error") {
  const Truth truth = truthOfBar();
  const image::Mask empty{100, 160, std::vector<std::uint8_t>(16000)};
  for (const image::Mask& part : {empty, image::Mask{}}) {
    const Score score = scorePart(truth, part, kStroke, {});
    CHECK(score.iou == 0);
    CHECK(score.iouBody == 0);
    CHECK(score.precision == 0);
    CHECK(score.recall == 0);
    CHECK_FALSE(score.ribs.has_value());
  }
}

TEST_CASE("half a part scores a half, and moving it by half its width a third") {
  const Truth truth = truthOfBar();
  image::Mask half = truthMask();
  for (std::size_t i = 0; i < half.pixels.size(); ++i) {
    if (i % 100 >= 50) half.pixels[i] = 0;
  }
  CHECK(scorePart(truth, half, kStroke, {}).iou == doctest::Approx(0.5));
  CHECK(scorePart(truth, half, kStroke, {}).recall == doctest::Approx(0.5));
  CHECK(scorePart(truth, half, kStroke, {}).precision == 1);
  const Score moved = scorePart(truth, bar(59.5, 10), kStroke, {});
  CHECK(moved.iou == doctest::Approx(1.0 / 3));
  CHECK(moved.iouBody == doctest::Approx(1.0 / 3));
}

TEST_CASE("what lies beyond the stroke counts in the whole but not in the body") {
  const Truth truth = truthOfBar();
  image::Mask cut = truthMask();
  for (int y = 0; y < 160; ++y) {
    if (y >= 38 && y <= 122) continue;
    for (int x = 0; x < 100; ++x) cut.pixels[static_cast<std::size_t>(y * 100 + x)] = 0;
  }
  const Score score = scorePart(truth, cut, kStroke, {});
  CHECK(score.iou == doctest::Approx(85.0 / 120));
  CHECK(score.iouBody == 1);
  const std::vector<PicturePoint> backwards(kStroke.rbegin(), kStroke.rend());
  CHECK(scorePart(truth, cut, backwards, {}).iouBody == 1);
}

TEST_CASE("rib errors are in percent of the width and counted against the tolerance") {
  const Truth truth = truthOfBar();
  const auto scoreOf = [&](double left, double right) {
    return *scorePart(truth, truthMask(), kStroke, endsAt(left, right)).ribs;
  };
  const double edge = scoreOf(39.5, 59.5).meanPx;
  CHECK(scoreOf(35.5, 63.5).meanPx == doctest::Approx(4 + edge).epsilon(0.1));
  CHECK(scoreOf(35.5, 63.5).meanPct == doctest::Approx(5 * scoreOf(35.5, 63.5).meanPx));
  CHECK(scoreOf(35.5, 63.5).withinTolerance == 0);
  CHECK(scoreOf(39.5, 65.5).withinTolerance == doctest::Approx(0.5));
  CHECK(scoreOf(39.5, 65.5).p95Pct > scoreOf(39.5, 65.5).meanPct);
}

TEST_CASE("do-not-care pixels are neither part nor background, and rib ends near them are left out") {
  image::Mask mask = truthMask();
  for (int y = 100; y < 160; ++y) {
    for (int x = 0; x < 100; ++x) mask.pixels[static_cast<std::size_t>(y * 100 + x)] = 128;
  }
  const Truth truth({mask, kAxis, 1.0});
  image::Mask wild = truthMask();
  for (std::size_t i = 10000; i < wild.pixels.size(); ++i) wild.pixels[i] = i % 3 ? 255 : 0;
  const Score score = scorePart(truth, wild, kStroke, endsAt(39.5, 59.5));
  CHECK(score.iou == 1);
  CHECK(score.iouBody == 1);
  REQUIRE(score.ribs.has_value());
  CHECK(score.ribs->count == 2 * 15);  // y = 40 … 96
  for (const PicturePoint& p : truth.boundary()) REQUIRE(p.y < 98);
}

TEST_CASE("an outline lies on the half-coverage line, holes included, and moves with the mask") {
  image::Mask mask = truthMask();
  for (int y = 60; y < 80; ++y) {
    for (int x = 45; x < 55; ++x) mask.pixels[static_cast<std::size_t>(y * 100 + x)] = 0;
  }
  const std::vector<PicturePoint> points = outline(mask);
  int hole = 0;
  for (const PicturePoint& p : points) {
    const auto beside = [](double v, double line) { return std::abs(v - line) <= 0.34; };
    const bool outer = beside(p.x, 39.5) || beside(p.x, 59.5) || beside(p.y, 19.5) || beside(p.y, 139.5);
    const bool inner = p.x > 44 && p.x < 56 && p.y > 59 && p.y < 80.5;
    REQUIRE((outer || inner));
    hole += inner;
  }
  CHECK(hole > 3 * 2 * (10 + 20) - 20);
  CHECK(outline(image::Mask{}).empty());
  CHECK(outline(image::Mask{4, 4, std::vector<std::uint8_t>(16)}).empty());
}

TEST_CASE("the body's pixels belong to the nearest part of the axis") {
  const Truth truth({truthMask(), {{20, 20, 5}, {20, 120, 5}, {80, 120, 5}}, 1.0});
  Rng rng(2);
  for (int i = 0; i < 3000; ++i) {
    const int x = static_cast<int>(rng.below(100)), y = static_cast<int>(rng.below(160));
    const double wanted = truth.arcAt({1.0 * x, 1.0 * y});
    const double got = truth.arcOfPixels()[static_cast<std::size_t>(y * 100 + x)];
    // The chamfer distance is within 2 % of the Euclidean one: only ties may go the other way.
    const auto at = [](double arc) { return arc <= 100 ? PicturePoint{20, 20 + arc} : PicturePoint{arc - 80, 120}; };
    const PicturePoint p{1.0 * x, 1.0 * y};
    REQUIRE(distance(p, at(got)) <= 1.03 * distance(p, at(wanted)) + 1);
  }
}

TEST_CASE("percentiles interpolate between the values") {
  CHECK(percentile({3, 1, 2}, 0.5) == 2);
  CHECK(percentile({0, 10}, 0.95) == doctest::Approx(9.5));
  CHECK(percentile({7}, 0.95) == 7);
}
