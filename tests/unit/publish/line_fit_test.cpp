#include "engine/publish/line_fit.h"

#include <doctest/doctest.h>

#include <cmath>

#include "engine/geometry/polyline.h"
#include "engine/io/foretold.h"
#include "engine/publish/line_on_grid.h"

using namespace spineloft;
using namespace spineloft::publish;

namespace {

constexpr image::Size kPicture{900, 700};
constexpr ribs::SpineParams kForty{.ribs = 40};

/// The spine of a line with a few bends.
ribs::Spine bent() {
  std::vector<PicturePoint> stroke;
  for (int i = 0; i <= 90; ++i)
    stroke.push_back({60 + 8.6 * i, 350 + 150 * std::sin(0.09 * i) + 40 * std::sin(0.23 * i)});
  return ribs::cleanSpine(stroke, kPicture, kForty).value();
}

double farOff(const std::vector<PicturePoint>& stroke, const ribs::Spine& wanted) {
  const auto got = ribs::cleanSpine(stroke, kPicture, kForty).value();
  REQUIRE(got.points.size() == wanted.points.size());
  double most = 0;
  for (std::size_t i = 0; i < wanted.points.size(); ++i)
    most = std::max(most, distance(got.points[i], wanted.points[i]));
  return most;
}

}  // namespace

TEST_CASE(
    "few points give nearly the wanted spine where evenly spaced points of it do not, and say how far off it is") {
  const ribs::Spine wanted = bent();
  const LineFit fit = fitLine(wanted, 36, kForty.smoothness);
  REQUIRE(fit.points.size() == 36);
  CHECK(std::abs(farthest(fit.off) - farOff(fit.points, wanted)) < 0.1);
  CHECK(farthest(fit.off) < 0.25);
  CHECK(farOff(geometry::resample(std::span(wanted.points), 36), wanted) > 5);
}

TEST_CASE(
    "points of a line are put on the grid, most where they are expected, and its spine stays within the tolerance") {
  const ribs::Spine wanted = bent();
  const LineFit fit = fitLine(wanted, 36, kForty.smoothness);
  for (const double step : {0.5, 1.0, 2.0}) {
    for (const std::size_t mode : io::kLineModes) {
      CAPTURE(step);
      const auto line = lineOnGrid(fit, {step, 0.9, 0.1}, io::kModes[mode].bend);
      REQUIRE(line);
      REQUIRE(line->points.size() == 36);
      std::vector<std::int64_t> placed, rounded;
      for (std::size_t i = 0; i < 36; ++i) {
        const PicturePoint p = line->points[i] * (1 / step), q = fit.points[i] * (1 / step);
        CHECK(p == PicturePoint{std::round(p.x), std::round(p.y)});
        placed.insert(placed.end(), {std::llround(p.x), std::llround(p.y)});
        rounded.insert(rounded.end(), {std::llround(q.x), std::llround(q.y)});
      }
      // It is within 0.9 as foretold from small moves.
      CHECK(farOff(line->points, wanted) <= 1.25);
      const auto cost = [&](const std::vector<std::int64_t>& numbers) {
        const std::vector<std::int64_t> off = io::offs(io::kModes[mode], numbers);
        std::size_t sum = 0;
        for (std::size_t i = 2; i < off.size(); ++i) sum += io::offCost(off[i]);
        return sum;
      };
      CHECK(cost(placed) < cost(rounded));
      CHECK(static_cast<double>(cost(placed)) <= line->cost);
    }
  }
}

TEST_CASE("a line whose spine cannot stay within the tolerance has no place on the grid") {
  const LineFit fit = fitLine(bent(), 4, kForty.smoothness);
  CHECK(farthest(fit.off) > 5);
  CHECK_FALSE(lineOnGrid(fit, {0.25, 0.9, 0.1}, 0));
}
