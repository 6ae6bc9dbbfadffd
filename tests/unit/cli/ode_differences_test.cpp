#include "engine/cli/ode_differences.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/base/rng.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::geometry;

namespace {

OdeEnds anyEnds(Rng& rng) { return {rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-4, 4), rng.uniform(-4, 4)}; }

/// Largest difference between the closed form and finite differences on n intervals.
double errorOf(const OdeEnds& ends, double tightness, std::size_t n) {
  const std::vector<double> forces(n - 1, 0.0);
  const std::vector<double> d = cli::differenceCurve(ends, tightness, forces);
  const OdeCurve curve(ends, tightness);
  double most = 0;
  for (std::size_t i = 0; i <= n; ++i) {
    most = std::max(most, std::abs(d[i] - curve.value(static_cast<double>(i) / static_cast<double>(n))));
  }
  return most;
}

double ringErrorOf(std::span<const double> values, double tightness, std::size_t n) {
  std::vector<cli::RingNode> known;
  std::vector<double> nodes, weights(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) {  // uneven places that are on every grid
    const std::size_t at = (k * 16 + (k % 2) * 5) % 64;
    known.push_back({at * n / 64, values[k]});
    nodes.push_back(static_cast<double>(at) / 64);
  }
  const std::vector<double> d = cli::differenceRing(known, tightness, n);
  const RingCardinals ring(nodes, tightness);
  double most = 0;
  for (std::size_t i = 0; i < n; ++i) {
    ring.at(static_cast<double>(i) / static_cast<double>(n), weights);
    double sum = 0;
    for (std::size_t k = 0; k < values.size(); ++k) sum += weights[k] * values[k];
    most = std::max(most, std::abs(sum - d[i]));
  }
  return most;
}

}  // namespace

TEST_CASE("the closed form of an interval is what finite differences tend to, in second order") {
  Rng rng(1);
  for (const double tightness : {0.0, 0.5, 2.0, 8.0, 16.0}) {
    for (int round = 0; round < testing::rounds(20); ++round) {
      CAPTURE(tightness);
      CAPTURE(round);
      const OdeEnds ends = anyEnds(rng);
      const double coarse = errorOf(ends, tightness, 64), middle = errorOf(ends, tightness, 128),
                   fine = errorOf(ends, tightness, 256);
      const double size = std::abs(ends.end - ends.start) + std::abs(ends.startSlope) + std::abs(ends.endSlope);
      CHECK(fine <= 2e-4 * size);
      if (fine < 1e-8) continue;  // a cubic with little in it: rounding
      CHECK(coarse / middle >= 3.4);
      CHECK(coarse / middle <= 4.2);
      CHECK(middle / fine >= 3.4);
      CHECK(middle / fine <= 4.2);
    }
  }
}

TEST_CASE("a rise of 1 with level ends is within 2e-4 of 256 finite differences") {
  for (const double tightness : {0.0, 1.0, 4.0, 16.0}) CHECK(errorOf({0, 1, 0, 0}, tightness, 256) <= 2e-4);
}

TEST_CASE("cardinal functions of a ring are what finite differences tend to") {
  for (const double tightness : {0.0, 4.0, 16.0}) {
    for (const std::size_t count : {1u, 2u, 3u, 4u}) {
      CAPTURE(tightness);
      CAPTURE(count);
      const std::vector<double> values = {0.3, -1, 0.7, 0.1};
      const std::span<const double> some = std::span(values).first(count);
      const double coarse = ringErrorOf(some, tightness, 64), middle = ringErrorOf(some, tightness, 128),
                   fine = ringErrorOf(some, tightness, 256);
      CHECK(fine <= 1e-3);
      if (fine < 1e-8) continue;
      CHECK(coarse / middle >= 3.4);
      CHECK(middle / fine >= 3.4);
      CHECK(middle / fine <= 4.2);
    }
  }
}

TEST_CASE("to blend residuals is to blend forces") {
  Rng rng(5);
  constexpr std::size_t kNodes = 64;
  for (const double tightness : {0.0, 3.0, 16.0}) {
    std::vector<double> first, second;
    const OdeEnds endsA = anyEnds(rng), endsB = anyEnds(rng);
    for (std::size_t i = 0; i <= kNodes; ++i) {  // any two curves with those ends
      const double t = static_cast<double>(i) / kNodes, bump = t * t * (1 - t) * (1 - t);
      first.push_back(OdeCurve(endsA, 0).value(t) + 9 * bump * std::sin(9 * t));
      second.push_back(OdeCurve(endsB, 0).value(t) - 7 * bump * t);
    }
    const auto mixed = [](double a, double b) { return 0.3 * a + 0.7 * b; };
    const OdeEnds ends{mixed(endsA.start, endsB.start), mixed(endsA.end, endsB.end),
                       mixed(endsA.startSlope, endsB.startSlope), mixed(endsA.endSlope, endsB.endSlope)};
    std::vector<double> forces = cli::differenceForces(first, endsA, tightness);
    const std::vector<double> others = cli::differenceForces(second, endsB, tightness);
    for (std::size_t i = 0; i < forces.size(); ++i) forces[i] = mixed(forces[i], others[i]);
    const std::vector<double> byForces = cli::differenceCurve(ends, tightness, forces);
    const std::vector<double> none(forces.size(), 0.0);
    const std::vector<double> base = cli::differenceCurve(ends, tightness, none),
                              baseA = cli::differenceCurve(endsA, tightness, none),
                              baseB = cli::differenceCurve(endsB, tightness, none);
    for (std::size_t i = 0; i <= kNodes; ++i) {
      const double byResiduals = base[i] + mixed(first[i] - baseA[i], second[i] - baseB[i]);
      CHECK(std::abs(byForces[i] - byResiduals) <= 1e-10);
    }
  }
}
