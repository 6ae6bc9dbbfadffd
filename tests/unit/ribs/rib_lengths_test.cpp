#include "engine/ribs/labels/rib_lengths.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/base/rng.h"
#include "engine/ribs/labels/pair_search.h"
#include "tests/support/rounds.h"
#include "tests/unit/ribs/length_problems.h"

using namespace spineloft;
using namespace spineloft::ribs;
using fixtures::pictureLikeProblem;
using fixtures::randomProblem;

namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

double leastByTrying(const LengthProblem& p) {
  const int ends = 2 * p.ribs;
  LengthLabels labels{std::vector<int>(index(p.ribs)), std::vector<int>(index(p.ribs))};
  double least = std::numeric_limits<double>::infinity();
  long combinations = 1;
  for (int e = 0; e < ends; ++e) combinations *= p.levels;
  for (long code = 0; code < combinations; ++code) {
    long rest = code;
    for (int e = 0; e < ends; ++e, rest /= p.levels) {
      (e < p.ribs ? labels.left[index(e)] : labels.right[index(e - p.ribs)]) = static_cast<int>(rest % p.levels);
    }
    least = std::min(least, energyOf(p, labels).total());
  }
  return least;
}

}  // namespace

TEST_CASE("the optimum is what trying every combination of labels finds") {
  Rng rng(31);
  LengthWorkspace workspace;
  for (int round = 0; round < testing::rounds(120); ++round) {
    const int ribs = 1 + static_cast<int>(rng.below(3)), levels = 2 + static_cast<int>(rng.below(4));
    const LengthProblem p = randomProblem(ribs, levels, round % 3 != 0, rng);
    const double found = energyOf(p, optimalLabels(p, workspace)).total();
    CHECK(found == doctest::Approx(leastByTrying(p)).epsilon(1e-5));
  }
}

TEST_CASE("chains side by side have the energies that each has alone") {
  Rng rng(37);
  LengthWorkspace workspace;
  for (int columns : {1, 3, 8}) {
    LengthProblem p = randomProblem(12, 20, false, rng);
    std::vector<float> together(p.left.unary.size() * index(columns));
    std::vector<double> alone;
    for (int q = 0; q < columns; ++q) {
      for (std::size_t i = 0; i < p.left.unary.size(); ++i) {
        if (p.left.unary[i] < kUnreachable) p.left.unary[i] = static_cast<float>(rng.uniform());
        together[i * index(columns) + index(q)] = p.left.unary[i];
      }
      alone.push_back(sideEnergy(p, p.left, optimalSide(p, p.left, workspace)));
    }
    std::vector<float> least;
    leastEnergies(p, p.left, {together, columns}, workspace, least);
    REQUIRE(least.size() == alone.size());
    for (int q = 0; q < columns; ++q) {
      CHECK(static_cast<double>(least[index(q)]) == doctest::Approx(alone[index(q)]).epsilon(1e-4));
    }
  }
}

TEST_CASE("without opposite costs the pair search and the side search agree") {
  Rng rng(32);
  LengthWorkspace workspace;
  for (int round = 0; round < testing::rounds(30); ++round) {
    LengthProblem p = randomProblem(30, 24, false, rng);
    const double apart = energyOf(p, optimalLabels(p, workspace)).total();
    p.opposite.assign(24 * 24, 0.f);
    CHECK(energyOf(p, optimalLabels(p, workspace)).total() == doctest::Approx(apart).epsilon(1e-5));
  }
}

TEST_CASE("swapping the sides swaps the labels' energy for the same value") {
  Rng rng(34);
  LengthWorkspace workspace;
  for (int round = 0; round < testing::rounds(20); ++round) {
    LengthProblem p = randomProblem(20, 16, true, rng);
    const double before = energyOf(p, optimalLabels(p, workspace)).total();
    std::swap(p.left, p.right);
    p.medialOffset = -p.medialOffset;
    CHECK(energyOf(p, optimalLabels(p, workspace)).total() == doctest::Approx(before).epsilon(1e-5));
  }
}

TEST_CASE("a gap in the edges is bridged at the level of its neighbours") {
  Rng rng(35);
  LengthProblem p = randomProblem(30, 40, false, rng);
  p.neighbourWeight = 3;
  p.neighbourFreedom = 0.25f;
  p.neighbourCap = kUnreachable;
  for (SideCosts* side : {&p.left, &p.right}) {
    for (int i = 0; i < 30; ++i) {
      for (int k = 0; k < 40; ++k) {
        side->unary[index(i * 40 + k)] = k == 17 && (i < 10 || i > 20) ? 0.f : 1.f;
        side->place[index(i * 40 + k)] = static_cast<float>(k);
      }
    }
  }
  LengthWorkspace workspace;
  const LengthLabels labels = optimalLabels(p, workspace);
  for (int i = 0; i < 30; ++i) {
    CHECK(std::abs(labels.left[index(i)] - 17) <= 1);
    CHECK(std::abs(labels.right[index(i)] - 17) <= 1);
  }
}

TEST_CASE("min-marginals are the least energy of the side through every label") {
  Rng rng(36);
  LengthWorkspace workspace;
  for (int round = 0; round < testing::rounds(30); ++round) {
    const LengthProblem p = randomProblem(4, 5, round % 2 == 0, rng);
    const LengthLabels best = optimalLabels(p, workspace);
    std::vector<float> marginals;
    sideMarginals(p, best, true, workspace, marginals);
    // By brute force over the left side with the right one held.
    std::vector<double> least(20, std::numeric_limits<double>::infinity());
    const double rest = [&] {
      double sum = 0;
      for (int i = 0; i < 4; ++i) {
        sum += static_cast<double>(p.right.unary[index(i * 5 + best.right[index(i)])]);
        if (i == 0) continue;
        sum += static_cast<double>(neighbourCost(p, p.right.place[index((i - 1) * 5 + best.right[index(i - 1)])],
                                                 p.right.place[index(i * 5 + best.right[index(i)])],
                                                 p.right.spacing[index(i - 1)]));
      }
      return sum;
    }();
    for (int code = 0; code < 625; ++code) {
      LengthLabels labels = best;
      for (int i = 0, c = code; i < 4; ++i, c /= 5) labels.left[index(i)] = c % 5;
      const double energy = energyOf(p, labels).total() - rest;
      for (int i = 0; i < 4; ++i) {
        double& slot = least[index(i * 5 + labels.left[index(i)])];
        slot = std::min(slot, energy);
      }
    }
    for (std::size_t k = 0; k < 20; ++k) {
      if (std::isfinite(least[k])) {
        CHECK(static_cast<double>(marginals[k]) == doctest::Approx(least[k]).epsilon(1e-4));
      } else {
        CHECK_FALSE(std::isfinite(marginals[k]));
      }
    }
  }
}

TEST_CASE("dropping labels by their bounds loses no optimum, and most pairs need no visit") {
  Rng rng(38);
  LengthWorkspace workspace, unbounded;
  double kept = 0, all = 0;
  for (int round = 0; round < testing::rounds(40); ++round) {
    const int ribs = 2 + static_cast<int>(rng.below(40));
    LengthProblem p = pictureLikeProblem(ribs, 40, rng);
    if (round % 2 == 0) p.neighbourCap = 5;
    LabelBounds everything;
    everything.left.assign(index(ribs), {0, p.levels});
    everything.right = everything.left;
    LengthLabels full, found;
    optimalPairs(p, everything, unbounded, full);
    REQUIRE(findLabels(p, std::numeric_limits<double>::infinity(), workspace, found));
    const double least = energyOf(p, full).total();
    CHECK(energyOf(p, found).total() == doctest::Approx(least).epsilon(1e-5));
    CHECK(workspace.bounds.lower <= least + 1e-3 + 1e-4 * std::abs(least));
    CHECK(workspace.bounds.upper >= least - 1e-3 - 1e-4 * std::abs(least));
    for (int i = 0; i < ribs; ++i) {
      const LabelRun &left = workspace.bounds.left[index(i)], &right = workspace.bounds.right[index(i)];
      CHECK((full.left[index(i)] >= left.low && full.left[index(i)] < left.high));
      CHECK((full.right[index(i)] >= right.low && full.right[index(i)] < right.high));
    }
    kept += workspace.bounds.cells();
    all += everything.cells();
  }
  CHECK(kept < 0.5 * all);
}

TEST_CASE("a search with a limit gives up only where nothing lies below it") {
  Rng rng(39);
  LengthWorkspace workspace;
  int givenUp = 0;
  for (int round = 0; round < testing::rounds(60); ++round) {
    const LengthProblem p = pictureLikeProblem(20, 30, rng);
    const double least = energyOf(p, optimalLabels(p, workspace)).total();
    LengthLabels labels;
    const double limit = least + rng.uniform(-3, 3);
    const bool found = findLabels(p, limit, workspace, labels);
    if (limit > least + 1e-3) CHECK(found);
    if (found) CHECK(energyOf(p, labels).total() == doctest::Approx(least).epsilon(1e-5));
    givenUp += found ? 0 : 1;
  }
  CHECK(givenUp > 5);
}
