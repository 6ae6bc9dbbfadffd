#include "engine/ribs/evidence/ink_centreline.h"

#include <doctest/doctest.h>

#include <cmath>

#include "engine/ribs/search/ribs.h"
#include "tests/unit/ribs/fixtures.h"

using namespace spineloft;
using namespace spineloft::ribs;

namespace {

constexpr image::Size kPicture{400, 300};

// A straight stroke along y = 150; what lies at a distance from it is the same all along.
struct Scene {
  image::EdgeMap map;
  Spine spine;
  GradientCurves curves;
  explicit Scene(const std::function<bool(double)>& dark)
      : map(fixtures::mapOf(kPicture, [&](PicturePoint p) { return dark(std::abs(p.y - 150)); })),
        spine(cleanSpine(fixtures::Points{{60, 150}, {340, 150}}, kPicture, {.ribs = 40}).value()) {
    const D2Field field(spine.points);
    traceCurves(spine, field, makeLevels(100, 1, 120, field.length()), 11, kPicture, curves);
  }
  double middle(double along) const { return middleOfLine(curves, map, curves.layout.left(20), along); }
  /// Mean distance of the rib ends from the spine, without those that bend round its ends.
  double reach() const {
    const RibSet set = traceRibs(spine, map, kPicture, {}, Progress()).value();
    double sum = 0;
    for (std::size_t i = 10; i < 30; ++i)
      sum += (std::abs(set.ribs[i].left.y - 150) + std::abs(set.ribs[i].right.y - 150)) / 2;
    return sum / 20;
  }
};

std::function<bool(double)> line(double from, double to) {
  return [=](double away) { return away >= from && away <= to; };
}

}  // namespace

TEST_CASE("from anywhere on a pen line or right beside it, its middle is found") {
  const Scene scene(line(40, 43.6));
  for (double along = 38.5; along < 45.2; along += 0.3) {
    CAPTURE(along);
    CHECK(scene.middle(along) == doctest::Approx(41.8).epsilon(0.015));
  }
}

TEST_CASE("the edge of a thing is no line, nor is a stripe that is broad, nor bare paper") {
  for (const auto& dark : {line(0, 40), line(40, 300), line(40, 60), line(400, 401)}) {
    const Scene scene(dark);
    for (double along = 35; along < 65; along += 1.7) CHECK(scene.middle(along) == along);
  }
}

TEST_CASE("ink that is broad against the thing itself belongs to it") {
  const Scene scene(line(10, 16));
  CHECK(scene.middle(16) == 16);
}

TEST_CASE("the ends of a drawn thing stand in the middle of its outline, however thick the pen") {
  for (const double half : {1.0, 1.5, 2.0}) {
    const Scene scene(line(45 - half, 45 + half));
    CHECK(scene.reach() == doctest::Approx(45).epsilon(0.02));
  }
}

TEST_CASE("a double line counts once, and it is the outer one") {
  const Scene scene([](double away) { return (away >= 40 && away <= 43) || (away >= 50 && away <= 53); });
  CHECK(scene.reach() == doctest::Approx(51.5).epsilon(0.02));
}
