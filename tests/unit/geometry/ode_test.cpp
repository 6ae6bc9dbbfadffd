#include "engine/geometry/ode.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "engine/base/rng.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::geometry;

namespace {

OdeEnds anyEnds(Rng& rng) { return {rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-4, 4), rng.uniform(-4, 4)}; }

}  // namespace

TEST_CASE("an interval has the values and slopes of its ends, for any tightness") {
  Rng rng(2);
  for (const double tightness : {0.0, 0.019, 0.021, 1.0, 50.0, 1e4}) {
    CAPTURE(tightness);
    const OdeEnds ends = anyEnds(rng);
    const OdeCurve curve(ends, tightness);
    CHECK(curve.value(0) == doctest::Approx(ends.start).epsilon(1e-8));
    CHECK(curve.value(1) == doctest::Approx(ends.end).epsilon(1e-8));
    CHECK(curve.slope(0) == doctest::Approx(ends.startSlope).epsilon(1e-7));
    CHECK(curve.slope(1) == doctest::Approx(ends.endSlope).epsilon(1e-7));
    // The equation itself, by differences of the second derivative.
    constexpr double kStep = 1e-3, kAt = 0.3;
    const double fourth =
        (curve.curvature(kAt - kStep) - 2 * curve.curvature(kAt) + curve.curvature(kAt + kStep)) / (kStep * kStep);
    const double second = tightness * tightness * curve.curvature(kAt);
    if (tightness <= 50) CHECK(std::abs(fourth - second) <= 1e-2 * (1 + std::abs(second)));
  }
}

TEST_CASE("where the closed form gives way to the cubic the two agree") {
  Rng rng(3);
  for (int round = 0; round < testing::rounds(20); ++round) {
    const OdeEnds ends = anyEnds(rng);
    const OdeCurve below(ends, kLeastTightness * (1 - 1e-9)), above(ends, kLeastTightness * (1 + 1e-9));
    for (const double t : {0.1, 0.37, 0.5, 0.8}) CHECK(std::abs(below.value(t) - above.value(t)) <= 3e-5);
  }
}

TEST_CASE("cardinal functions are 1 at their node and 0 at the others, and add up to 1") {
  const std::vector<double> nodes = {0.05, 0.2, 0.65, 0.9};
  const RingCardinals ring(nodes, 7);
  std::vector<double> weights(4);
  for (std::size_t k = 0; k < 4; ++k) {
    ring.at(nodes[k], weights);
    for (std::size_t i = 0; i < 4; ++i) CHECK(weights[i] == doctest::Approx(i == k ? 1.0 : 0.0));
  }
  for (double u = -1; u < 2; u += 0.0301) {
    ring.at(u, weights);
    CHECK(weights[0] + weights[1] + weights[2] + weights[3] == doctest::Approx(1.0));
  }
}

TEST_CASE("two opposite nodes are joined by 3t^2 - 2t^3") {
  const std::vector<double> nodes = {0, 0.5};
  const RingCardinals ring(nodes, 0);
  std::vector<double> weights(2);
  for (const double t : {0.0, 0.2, 0.5, 0.9}) {
    ring.at(t / 2, weights);
    CHECK(weights[1] == doctest::Approx(3 * t * t - 2 * t * t * t));
  }
}
