// What a hand does to shapes: lines at outlines, other measures, primitives fitted to things.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "engine/geometry/polygon.h"
#include "engine/geometry/polyline.h"
#include "engine/shape/reshape.h"
#include "engine/shape/shape.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::shape;

namespace {

using Line = std::vector<PicturePoint>;

Line ellipse(PicturePoint middle, double a, double b, double turn = 0, int n = 200) {
  Line line;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * std::numbers::pi * i / n, x = a * std::cos(t), y = b * std::sin(t);
    line.push_back(middle +
                   PicturePoint{x * std::cos(turn) - y * std::sin(turn), x * std::sin(turn) + y * std::cos(turn)});
  }
  return line;
}

double away(const Line& outline, PicturePoint p) {
  double least = 1e9;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    least = std::min(least, geometry::distanceToSegment(p, outline[i], outline[(i + 1) % outline.size()]));
  }
  return least;
}

double areaOf(const Line& line) { return std::abs(geometry::signedArea(std::span<const PicturePoint>(line))); }

ShapeParams paramsOf(Primitive primitive, Axis axis, double width) {
  ShapeParams params;
  params.primitive = primitive;
  params.axis = axis;
  params.width = width;
  return params;
}

Line seenOf(const ShapeParams& params, const std::optional<geometry::View>& view = std::nullopt) {
  auto line = outlineSeen(params, {}, view);
  REQUIRE(line.ok());
  return line.value();
}

}  // namespace

TEST_CASE("the outline of a primitive is seen from the front, a side, the back and above") {
  const ShapeParams ball = paramsOf(Primitive::Ball, {{100, 160}, {100, 40}}, 120);
  for (const PicturePoint p : seenOf(ball)) CHECK(distance(p, {100, 100}) == doctest::Approx(60).epsilon(0.001));
  // The side picture is half as large: its pixel (50, 50) shows Y = -100, Z = 0.
  const geometry::View side{geometry::ViewFrom::Right, 50, 2, 0};
  for (const PicturePoint p : seenOf(ball, side)) CHECK(distance(p, {50, 50}) == doctest::Approx(30).epsilon(0.001));
  const geometry::View back{geometry::ViewFrom::Back, -10, 1, 200};
  for (const PicturePoint p : seenOf(ball, back)) CHECK(distance(p, {100, 90}) == doctest::Approx(60).epsilon(0.001));
  const geometry::View top{geometry::ViewFrom::Top, 30, 1, 0};
  for (const PicturePoint p : seenOf(ball, top)) CHECK(distance(p, {100, 30}) == doctest::Approx(60).epsilon(0.01));
}

TEST_CASE("a line over one side takes the place of that side; the other one stays") {
  const Line before = ellipse({100, 100}, 40, 60);
  Line bump;
  for (int i = 0; i <= 40; ++i) {
    const double t = std::numbers::pi * (i / 40.0 - 0.5);
    bump.push_back({100 + 70 * std::cos(t), 100 + 60 * std::sin(t)});
  }
  for (const bool backwards : {false, true}) {
    Line line = bump;
    if (backwards) std::ranges::reverse(line);
    const Line after = redrawn(before, line);
    for (const PicturePoint p : bump) CHECK(away(after, p) < 1);
    CHECK(away(after, {60, 100}) < 1);
    CHECK(away(after, {64.7, 72}) < 1);
    CHECK(areaOf(after) == doctest::Approx(std::numbers::pi * 60 * (70 + 40) / 2).epsilon(0.01));
    CHECK(after.size() <= 64);
  }
}

TEST_CASE("ends near the outline are brought onto it, and a short line changes only what it passes") {
  const Line before = ellipse({100, 100}, 50, 50);
  Line line;
  for (int i = 0; i <= 30; ++i) {
    const double t = -0.5 + i / 30.0, r = 51 + 10 * std::cos(t * std::numbers::pi);
    line.push_back({100 + r * std::cos(t), 100 + r * std::sin(t)});
  }
  const Line after = redrawn(before, line);
  for (const PicturePoint p : ellipse({100, 100}, 50, 50)) {
    if (p.x < 130) CHECK(away(after, p) < 1);
  }
  CHECK(away(after, {161, 100}) < 1);
  const Line middle(line.begin() + 10, line.begin() + 21);
  for (const PicturePoint p : middle) CHECK(away(after, p) < 1);
}

TEST_CASE("a closed line is the whole outline, also where its ends run past each other") {
  const Line before = ellipse({100, 100}, 40, 60);
  Line round = ellipse({100, 100}, 80, 30);
  CHECK(isWhole(before, [&] {
    Line closed = round;
    closed.push_back(closed.front());
    return closed;
  }()));
  round.insert(round.end(), {{182, 103}, {181, 110}, {178, 116}});
  const Line after = redrawn(before, round);
  CHECK(areaOf(after) == doctest::Approx(std::numbers::pi * 80 * 30).epsilon(0.02));
  CHECK(geometry::isSimple([&] {
    std::vector<SectionPoint> points;
    for (const PicturePoint p : after) points.push_back({p.x, p.y});
    return points;
  }()));
  CHECK_FALSE(isWhole(before, {{60, 100}, {30, 100}, {60, 40}}));
  CHECK(redrawn(before, {{5, 5}, {5, 5}}) == before);
}

TEST_CASE("random lines at random outlines: the line is on the new outline") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int round = 0; round < testing::rounds(200); ++round) {
    const double a = 30 + 60 * unit(random), b = 30 + 60 * unit(random), from = 6 * unit(random);
    const double span = 0.4 + 3 * unit(random), out = 0.8 + 0.5 * unit(random);
    const Line before = ellipse({100, 100}, a, b);
    Line line;
    for (int i = 0; i <= 40; ++i) {
      const double t = from + span * i / 40, k = 1 + (out - 1) * std::sin(std::numbers::pi * i / 40);
      line.push_back({100 + a * k * std::cos(t), 100 + b * k * std::sin(t)});
    }
    const Line after = redrawn(before, line);
    double worst = 0;
    for (const PicturePoint p : line) worst = std::max(worst, away(after, p));
    CHECK(worst < 1);
    const double opposite = from + span / 2 + std::numbers::pi;
    CHECK(away(after, {100 + a * std::cos(opposite), 100 + b * std::sin(opposite)}) < 1);
  }
}

TEST_CASE("what is carried lies where it lay in shares of length and width") {
  const ShapeParams from = paramsOf(Primitive::Box, {{100, 200}, {100, 100}}, 50);
  const ShapeParams to = paramsOf(Primitive::Box, {{0, 0}, {200, 0}}, 100);
  CHECK(distance(carried(PicturePoint{100, 100}, from, to), {200, 0}) < 1e-9);
  // To the right of the way stays to the right of it.
  CHECK(distance(carried(PicturePoint{125, 150}, from, to), {100, 50}) < 1e-9);
  const geometry::View side{geometry::ViewFrom::Right, 50, 2, 0};
  const ShapeParams longer = paramsOf(Primitive::Box, {{100, 300}, {100, 100}}, 50);
  CHECK(distance(carried(PicturePoint{20, 100}, side, from, longer), {20, 150}) < 1e-9);
  CHECK(distance(carried(PicturePoint{20, 50}, side, from, longer), {20, 50}) < 1e-9);
}

TEST_CASE("a primitive fitted to a thing has its long way and its extents") {
  const auto fit = [](const Line& outline) {
    const auto fitted = fittedTo({}, outline);
    REQUIRE(fitted.ok());
    return fitted.value();
  };
  for (const double turn : {0.0, 0.4, 1.2, -0.9}) {
    const ShapeParams found = fit(ellipse({100, 100}, 80, 30, turn));
    CHECK(distance(found.axis.from, found.axis.to) == doctest::Approx(160).epsilon(0.01));
    CHECK(found.width == doctest::Approx(60).epsilon(0.01));
    const PicturePoint way = normalized(found.axis.to - found.axis.from);
    CHECK(std::abs(cross(way, {std::cos(turn), std::sin(turn)})) < 0.02);
  }
  const ShapeParams round = fit(ellipse({100, 100}, 50, 50));
  CHECK(round.axis.from.y == doctest::Approx(150).epsilon(0.01));
  CHECK(round.axis.to.y == doctest::Approx(50).epsilon(0.01));
  // A thing that is wide at its head begins there.
  const ShapeParams cone = fit({{60, 20}, {140, 20}, {100, 200}});
  CHECK(cone.axis.from == PicturePoint{100, 20});
  CHECK(cone.axis.to == PicturePoint{100, 200});
  CHECK(cone.width == doctest::Approx(80));
  CHECK(fittedTo({}, {{1, 1}, {2, 1}, {1, 2}}).failure().error == Error::RegionEmpty);
}

TEST_CASE("aligned by its outline, a picture shows the thing as high, or as wide, as the front does") {
  const Line front = ellipse({300, 200}, 60, 120);
  const auto extent = [&](geometry::ViewFrom from, const Line& seen) {
    const auto view = alignedView(from, seen, front);
    REQUIRE(view);
    ModelPoint low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
    for (const PicturePoint p : seen) {
      const ModelPoint m = geometry::inModel(*view, p);
      low = {std::min(low.x, m.x), std::min(low.y, m.y), std::min(low.z, m.z)};
      high = {std::max(high.x, m.x), std::max(high.y, m.y), std::max(high.z, m.z)};
    }
    return std::pair(low, high);
  };
  const Line seen = ellipse({70, 90}, 20, 40);
  for (const auto from : {geometry::ViewFrom::Right, geometry::ViewFrom::Left}) {
    const auto [low, high] = extent(from, seen);
    CHECK(low.y == doctest::Approx(-320));
    CHECK(high.y == doctest::Approx(-80));
    CHECK(low.z == doctest::Approx(-60));
    CHECK(high.z == doctest::Approx(60));
  }
  const auto [backLow, backHigh] = extent(geometry::ViewFrom::Back, seen);
  CHECK(backHigh.x == doctest::Approx(360));
  CHECK(backHigh.y == doctest::Approx(-80));
  CHECK(backLow.y == doctest::Approx(-320));
  const auto [topLow, topHigh] = extent(geometry::ViewFrom::Top, seen);
  CHECK(topLow.x == doctest::Approx(240));
  CHECK(topHigh.x == doctest::Approx(360));
  CHECK(topLow.z == doctest::Approx(-topHigh.z));
  CHECK_FALSE(alignedView(geometry::ViewFrom::Right, {{1, 1}, {2, 1}, {3, 1}}, front));
}
