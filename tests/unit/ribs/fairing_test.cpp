#include "engine/ribs/labels/fairing.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/base/rng.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::ribs;

namespace {

SideLengths sideOf(const std::vector<double>& length, double trust = 1) {
  return {length, std::vector<double>(length.size(), trust)};
}

std::vector<double> ramp(std::size_t count, double from, double step) {
  std::vector<double> line;
  for (std::size_t i = 0; i < count; ++i) line.push_back(from + step * static_cast<double>(i));
  return line;
}

double farthest(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

std::vector<double> faired(const SideLengths& side, const FairingParams& params) {
  FairingMemory memory;
  return fairLengths(side, params, memory);
}

}  // namespace

TEST_CASE("a steady taper is not punished: straight lines come back as they are") {
  for (const double step : {-0.4, 0.0, 0.7}) {
    const std::vector<double> line = ramp(60, 50, step);
    CHECK(farthest(faired(sideOf(line), {.stiffness = 200}), line) < 1e-9);
  }
}

TEST_CASE("few lengths, and lengths that nothing shall change, come back bit for bit") {
  const std::vector<double> wild{3, 9, 1, 8};
  CHECK(faired(sideOf(wild), {}) == wild);
  CHECK(faired(sideOf({}), {}).empty());
  const std::vector<double> longer{3, 9, 1, 8, 2, 7, 3};
  CHECK(faired(sideOf(longer), {.stiffness = 0}) == longer);
}

TEST_CASE("an end without an edge goes to the line of those that have one") {
  const std::vector<double> truth = ramp(50, 40, 0.3);
  SideLengths side = sideOf(truth);
  for (const std::size_t i : {20, 21, 22, 23, 24, 25}) {
    side.length[i] += 15;
    side.trust[i] = 0;
  }
  CHECK(farthest(faired(side, {}), truth) < 1);
}

TEST_CASE("a step between sure ends stays a step") {
  std::vector<double> step(60, 30);
  std::fill(step.begin() + 30, step.end(), 60);
  const std::vector<double> fair = faired(sideOf(step), {});
  CHECK(farthest(fair, step) < 6);
  CHECK(fair[31] - fair[28] > 22);
}

TEST_CASE("noise becomes less, on straight and on curved sides") {
  Rng rng(5);
  for (int round = 0; round < testing::rounds(20); ++round) {
    std::vector<double> truth, noisy;
    const double wave = rng.uniform(0, 8);
    for (int i = 0; i < 100; ++i) {
      truth.push_back(50 + wave * std::sin(i * 0.06));
      noisy.push_back(truth.back() + rng.uniform(-1.5, 1.5));
    }
    const std::vector<double> fair = faired(sideOf(noisy), {});
    double before = 0, after = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      before += std::pow(noisy[i] - truth[i], 2);
      after += std::pow(fair[i] - truth[i], 2);
    }
    CHECK(after < 0.7 * before);
  }
}

TEST_CASE("which end comes first, and the unit of length, make no difference") {
  Rng rng(11);
  SideLengths side;
  for (int i = 0; i < 40; ++i) {
    side.length.push_back(30 + rng.uniform(-5, 5));
    side.trust.push_back(rng.uniform());
  }
  const std::vector<double> fair = faired(side, {});
  SideLengths back = side;
  std::ranges::reverse(back.length);
  std::ranges::reverse(back.trust);
  std::vector<double> mirrored = faired(back, {});
  std::ranges::reverse(mirrored);
  CHECK(farthest(mirrored, fair) < 1e-9);
  SideLengths large = side;
  for (double& length : large.length) length *= 100;
  std::vector<double> scaled = faired(large, {});
  for (double& length : scaled) length /= 100;
  CHECK(farthest(scaled, fair) < 1e-9);
}
