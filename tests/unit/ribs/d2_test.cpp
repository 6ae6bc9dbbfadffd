#include "engine/ribs/field/d2.h"

#include <doctest/doctest.h>

#include <cmath>

#include "engine/base/rng.h"
#include "tests/support/rounds.h"
#include "tests/unit/ribs/fixtures.h"

using namespace spineloft;
using namespace spineloft::ribs;
using fixtures::Points;

namespace {

// d2 by composite Simpson quadrature of the defining integral.
double quadrature(const Points& p, PicturePoint x, int panels) {
  double sum = 0, length = 0;
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    const double t = distance(p[i], p[i + 1]);
    length += t;
    for (int k = 0; k <= 2 * panels; ++k) {
      const PicturePoint d = lerp(p[i], p[i + 1], k / (2.0 * panels)) - x;
      const double weight = k == 0 || k == 2 * panels ? 1 : k % 2 == 1 ? 4 : 2;
      sum += weight * t / (6.0 * panels) / dot(d, d);
    }
  }
  return std::sqrt(length / sum);
}

double nearest(const Points& p, PicturePoint x) {
  double best = 1e300;
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    for (int k = 0; k <= 20; ++k) best = std::min(best, distance(x, lerp(p[i], p[i + 1], k / 20.0)));
  }
  return best;
}

}  // namespace

TEST_CASE("d2 is the integral of its definition, over random polylines and points") {
  Rng rng(11);
  for (int round = 0; round < testing::rounds(40); ++round) {
    const Points p = fixtures::wander(rng, 2 + rng.below(30), 9);
    const D2Field field(p);
    for (int i = 0; i < 20; ++i) {
      const PicturePoint x{rng.uniform(100, 700), rng.uniform(100, 700)};
      if (nearest(p, x) < 2) continue;
      CHECK(field.distance(x) == doctest::Approx(quadrature(p, x, 200)).epsilon(1e-7));
    }
  }
}

TEST_CASE("the gradient of d2 is what finite differences say") {
  Rng rng(12);
  const double h = 1e-4;
  for (int round = 0; round < testing::rounds(60); ++round) {
    const Points p = fixtures::wander(rng, 2 + rng.below(40), 7);
    const D2Field field(p);
    const PicturePoint x{rng.uniform(100, 700), rng.uniform(100, 700)};
    if (nearest(p, x) < 2) continue;
    const PicturePoint g = field.sample(x).gradient;
    CHECK(g.x ==
          doctest::Approx((field.distance({x.x + h, x.y}) - field.distance({x.x - h, x.y})) / (2 * h)).epsilon(1e-5));
    CHECK(g.y ==
          doctest::Approx((field.distance({x.x, x.y + h}) - field.distance({x.x, x.y - h})) / (2 * h)).epsilon(1e-5));
  }
}

TEST_CASE("on a segment d2 is 0, on its line beyond the ends it joins smoothly") {
  const D2Field field(Points{{0, 0}, {60, 0}, {100, 0}});
  for (double x : {0.5, 30.0, 99.0}) CHECK(field.distance({x, 0}) == 0);
  CHECK(field.sample({30, 0}).gradient == PicturePoint{});
  // On the line I = T / (near · far).
  for (double x : {101.0, 130.0, 500.0, -3.0}) {
    const double expected = std::sqrt(100.0 / (100.0 / std::abs(x * (x - 100))));
    CHECK(field.distance({x, 0}) == doctest::Approx(expected).epsilon(1e-9));
    for (double off : {1e-9, 1e-6, 1e-4, 1e-3}) {
      CHECK(field.distance({x, off}) == doctest::Approx(expected).epsilon(1e-5));
      const D2Sample up = field.sample({x, off}), on = field.sample({x, 0});
      CHECK(distance(up.gradient, on.gradient) < 0.01);
    }
  }
}

TEST_CASE("d2 moves with a rigid motion, turns its gradient, and grows with scale") {
  Rng rng(13);
  for (int round = 0; round < testing::rounds(30); ++round) {
    const Points p = fixtures::wander(rng, 20, 9);
    const double turn = rng.uniform(0, 6.28), scale = rng.uniform(0.2, 5);
    const PicturePoint shift{rng.uniform(-500, 500), rng.uniform(-500, 500)};
    const auto rotate = [turn](PicturePoint q) {
      return PicturePoint{q.x * std::cos(turn) - q.y * std::sin(turn), q.x * std::sin(turn) + q.y * std::cos(turn)};
    };
    Points moved;
    for (PicturePoint q : p) moved.push_back(rotate(q) * scale + shift);
    const PicturePoint x{rng.uniform(100, 700), rng.uniform(100, 700)};
    if (nearest(p, x) < 2) continue;
    const D2Sample before = D2Field(p).sample(x), after = D2Field(moved).sample(rotate(x) * scale + shift);
    CHECK(after.d2 == doctest::Approx(before.d2 * scale).epsilon(1e-9));
    CHECK(distance(after.gradient, rotate(before.gradient)) < 1e-8);
  }
}

TEST_CASE("far away d2 is the Euclidean distance, and repeated points change nothing") {
  const Points p{{0, 0}, {0, 0}, {3, 1}, {3, 1}, {7, -2}};
  const D2Field field(p), clean(Points{{0, 0}, {3, 1}, {7, -2}});
  const PicturePoint far{4000, 3000};
  CHECK(field.distance(far) == doctest::Approx(distance(far, PicturePoint{3.5, 0})).epsilon(1e-3));
  CHECK(field.distance({20, 5}) == clean.distance({20, 5}));
  CHECK(field.length() == clean.length());
}

TEST_CASE("the single-precision kernel agrees with double precision to 3e-5 beyond one pixel") {
  Rng rng(14);
  for (int round = 0; round < testing::rounds(60); ++round) {
    const Points p = fixtures::wander(rng, 2 + rng.below(200), 4);
    const D2Field field(p);
    for (int i = 0; i < 30; ++i) {
      const PicturePoint x{rng.uniform(-200, 1000), rng.uniform(-200, 1000)};
      if (nearest(p, x) < 1) continue;
      const D2Sample exact = field.sample(x);
      const D2Integral quick = field.integral(x);
      const double value = static_cast<double>(quick.value);
      const double d2 = std::sqrt(field.length() / value);
      CHECK(d2 == doctest::Approx(exact.d2).epsilon(3e-5));
      const PicturePoint g{static_cast<double>(quick.gradientX), static_cast<double>(quick.gradientY)};
      // Coordinates of 1,000 px are rounded to 6e-5 px, which a pixel away turns the gradient by several times that.
      CHECK(distance(g * (-0.5 * d2 / value), exact.gradient) < 1e-3);
    }
  }
}

TEST_CASE("far stretches by their moments change d2 and its gradient by less than 2e-3") {
  Rng rng(15);
  double worst = 0, turned = 0;
  for (int round = 0; round < testing::rounds(60); ++round) {
    const Points p = fixtures::wander(rng, 2 + rng.below(300), 5);
    const D2Field field(p);
    for (int i = 0; i < 30; ++i) {
      const PicturePoint x{rng.uniform(-200, 1000), rng.uniform(-200, 1000)};
      if (nearest(p, x) < 1) continue;
      const D2Integral exact = field.integral(x), quick = field.quickIntegral(x);
      worst = std::max(worst, std::abs(static_cast<double>(quick.value / exact.value) - 1));
      const double dx = static_cast<double>(quick.gradientX - exact.gradientX);
      const double dy = static_cast<double>(quick.gradientY - exact.gradientY);
      turned = std::max(turned, std::hypot(dx, dy) / static_cast<double>(std::hypot(exact.gradientX, exact.gradientY)));
    }
  }
  CHECK(worst < 2e-3);
  CHECK(turned < 1e-2);
}

TEST_CASE("the radius of a straight spine and its d2 are inverse to each other") {
  for (double length : {5.0, 100.0, 3000.0}) {
    for (double radius : {0.01, 1.0, 50.0, 2000.0}) {
      CHECK(radiusOfD2(d2OfRadius(radius, length), length) == doctest::Approx(radius).epsilon(1e-9));
    }
    const D2Field field(Points{{0, 0}, {length, 0}});
    CHECK(d2OfRadius(7, length) == doctest::Approx(field.distance({length / 2, 7})).epsilon(1e-12));
  }
}
