#include "engine/ribs/field/curves.h"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/support/rounds.h"
#include "tests/unit/ribs/fixtures.h"

using namespace spineloft;
using namespace spineloft::ribs;
using fixtures::Points;

namespace {

constexpr image::Size kPicture{800, 800};

GradientCurves curvesOf(const Spine& spine, const Levels& levels, int fan) {
  GradientCurves curves;
  traceCurves(spine, D2Field(spine.points), levels, fan, kPicture, curves);
  return curves;
}

bool segmentsCross(PicturePoint a, PicturePoint b, PicturePoint c, PicturePoint d) {
  const double s1 = cross(b - a, c - a), s2 = cross(b - a, d - a);
  const double s3 = cross(d - c, a - c), s4 = cross(d - c, b - c);
  return s1 * s2 < 0 && s3 * s4 < 0;
}

// Where the flow along ∇d2 from `x` reaches a level set of d2: classic Runge–Kutta in small steps of the
// exact field.
PicturePoint followed(const D2Field& field, PicturePoint x, double level) {
  constexpr int kSteps = 400;
  const double from = field.distance(x);
  const auto slope = [&](PicturePoint at) {
    const PicturePoint g = field.sample(at).gradient;
    return g / dot(g, g);
  };
  // Even in ratio, for curves bend near the spine.
  const double ratio = std::pow(level / from, 1.0 / kSteps);
  double d2 = from;
  for (int i = 0; i < kSteps; ++i) {
    const double h = d2 * (ratio - 1);
    const PicturePoint a = slope(x), b = slope(x + a * (h / 2)), c = slope(x + b * (h / 2)), d = slope(x + c * h);
    x = x + (a + b * 2.0 + c * 2.0 + d) * (h / 6);
    d2 *= ratio;
  }
  return x;
}

}  // namespace

TEST_CASE("levels grow from the spine to the farthest radius, evenly where they reach") {
  const Levels fine = makeLevels(64, 1, 50, 400), wide = makeLevels(64, 1, 500, 400);
  CHECK(fine.radius.back() == doctest::Approx(50));
  CHECK(wide.radius.back() == doctest::Approx(500));
  CHECK(fine.radius[1] - fine.radius[0] == doctest::Approx(fine.radius[63] - fine.radius[62]));
  for (const Levels* levels : {&fine, &wide}) {
    CHECK(levels->radius[0] == 0);
    CHECK(levels->d2[0] == 0);
    for (std::size_t k = 1; k < levels->size(); ++k) {
      CHECK(levels->radius[k] > levels->radius[k - 1]);
      CHECK(levels->d2[k] > levels->d2[k - 1]);
      CHECK(levels->d2[k] == doctest::Approx(d2OfRadius(levels->radius[k], 400)));
    }
  }
  CHECK(wide.radius[1] == doctest::Approx(1).epsilon(0.01));
}

TEST_CASE("every point of a curve lies on its level set of d2") {
  Rng rng(41);
  const int rounds = testing::rounds(12);
  int seen = 0;
  for (int round = 0; round < rounds; ++round) {
    const auto spine = cleanSpine(fixtures::wander(rng, 40, 8), kPicture, {});
    if (!spine.ok()) continue;
    ++seen;
    const D2Field field(spine.value().points);
    const Levels levels = makeLevels(96, 1, 250, field.length());
    const GradientCurves curves = curvesOf(spine.value(), levels, 7);
    for (int c = 0; c < curves.layout.total(); ++c) {
      for (int k = 4; k < curves.reached[static_cast<std::size_t>(c)]; k += 7) {
        const double radius = radiusOfD2(field.distance(curves.point(c, k)), field.length());
        CHECK(std::abs(radius - levels.radius[static_cast<std::size_t>(k)]) < 0.5);
      }
    }
  }
  CHECK(seen > rounds / 2);
}

TEST_CASE("curves end within a tenth of a pixel of where the flow of d2 goes") {
  Rng rng(43);
  int seen = 0;
  double worst = 0;
  for (int round = 0; round < testing::rounds(6); ++round) {
    const auto spine = cleanSpine(fixtures::wander(rng, 40, 8), kPicture, {});
    if (!spine.ok()) continue;
    const D2Field field(spine.value().points);
    const Levels levels = makeLevels(128, 1, 0.4 * field.length(), field.length());
    const GradientCurves curves = curvesOf(spine.value(), levels, 7);
    for (int c = 5; c < curves.layout.total(); c += 23) {
      const int last = curves.reached[static_cast<std::size_t>(c)] - 1;
      // A curve that runs into a saddle goes either way.
      const double radius = levels.radius[static_cast<std::size_t>(last)];
      const bool frame = last < 127;
      if (last < 60 || (frame && static_cast<double>(curves.along[curves.at(c, last)]) > 2 * radius)) continue;
      const PicturePoint there =
          followed(field, curves.seeds[static_cast<std::size_t>(c)][1], levels.d2[static_cast<std::size_t>(last)]);
      worst = std::max(worst, distance(there, curves.point(c, last)));
      ++seen;
    }
  }
  CHECK(seen > 20);
  CHECK(worst <= 0.1);
}

TEST_CASE("steps of curves grow with their number, not faster") {
  Rng rng(44);
  const auto stroke = fixtures::wander(rng, 40, 8);
  const auto stepsOf = [&](int ribs) {
    SpineParams params;
    params.ribs = ribs;
    params.minSpacing = 0.1;
    const Spine spine = cleanSpine(stroke, kPicture, params).value();
    REQUIRE(static_cast<int>(spine.points.size()) == ribs);
    const GradientCurves curves = curvesOf(spine, makeLevels(128, 1, 250, D2Field(spine.points).length()), 11);
    return static_cast<double>(curves.steps) / curves.layout.total();
  };
  const double few = stepsOf(50);
  CHECK(few > 4);
  for (const int ribs : {100, 200, 400}) CHECK(stepsOf(ribs) < 1.35 * few);
}

TEST_CASE("curves never cross, neither on one side nor around the ends") {
  Rng rng(42);
  const int rounds = testing::rounds(12);
  int seen = 0;
  for (int round = 0; round < rounds; ++round) {
    const auto spine = cleanSpine(fixtures::wander(rng, 60, 8), kPicture, {.ribs = 60});
    if (!spine.ok()) continue;
    ++seen;
    const Levels levels = makeLevels(48, 2, 200, D2Field(spine.value().points).length());
    const GradientCurves curves = curvesOf(spine.value(), levels, 9);
    int occludedStretches = 0;
    for (int c = 0; c < curves.layout.total(); ++c) {
      const int d = (c + 1) % curves.layout.total();
      const int reachC = curves.reached[static_cast<std::size_t>(c)];
      const int reachD = curves.reached[static_cast<std::size_t>(d)];
      for (int k = 1; k + 1 < reachC; ++k) {
        for (int q = 1; q + 1 < reachD; ++q) {
          occludedStretches +=
              segmentsCross(curves.point(c, k), curves.point(c, k + 1), curves.point(d, q), curves.point(d, q + 1)) ? 1
                                                                                                                    : 0;
        }
      }
    }
    CHECK(occludedStretches == 0);
  }
  CHECK(seen > rounds / 2);
}

TEST_CASE("from a straight spine the middle curves go straight out, left as the screen sees it") {
  const auto spine = cleanSpine(Points{{200, 400}, {600, 400}}, kPicture, {.ribs = 101});
  REQUIRE(spine.ok());
  const Levels levels = makeLevels(64, 1, 60, 400);
  const GradientCurves curves = curvesOf(spine.value(), levels, 5);
  for (int k = 1; k < 64; k += 6) {
    const double radius = levels.radius[static_cast<std::size_t>(k)];
    CHECK(distance(curves.point(curves.layout.left(50), k), PicturePoint{400, 400 - radius}) < 0.05);
    CHECK(distance(curves.point(curves.layout.right(50), k), PicturePoint{400, 400 + radius}) < 0.05);
  }
  // Drawn to the right: the fan around the end points to the right, the other to the left.
  CHECK(curves.point(curves.layout.endFan(2), 40).x > 610);
  CHECK(curves.point(curves.layout.startFan(2), 40).x < 190);
}

TEST_CASE("curves stop at the picture's frame and always hold the spine point") {
  const auto spine = cleanSpine(Points{{10, 20}, {780, 20}}, kPicture, {});
  REQUIRE(spine.ok());
  const Levels levels = makeLevels(128, 1, 700, 770);
  const GradientCurves curves = curvesOf(spine.value(), levels, 9);
  for (int c = 0; c < curves.layout.total(); ++c) {
    const int reached = curves.reached[static_cast<std::size_t>(c)];
    REQUIRE(reached >= 1);
    for (int k = 0; k < reached; ++k) {
      const PicturePoint p = curves.point(c, k);
      CHECK((p.x >= -0.501 && p.y >= -0.501 && p.x <= 799.501 && p.y <= 799.501));
      if (k > 0) CHECK(curves.along[curves.at(c, k)] > curves.along[curves.at(c, k - 1)]);
    }
  }
  CHECK(curves.reached[static_cast<std::size_t>(curves.layout.left(50))] < 40);
}
