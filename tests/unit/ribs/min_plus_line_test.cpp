#include "engine/ribs/labels/min_plus_line.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "engine/base/rng.h"
#include "engine/ribs/labels/min_plus_step.h"

using namespace spineloft;
using namespace spineloft::ribs;

namespace {

// Two ribs of random places and spacing, windows from none to many labels.
LengthProblem twoRibs(Rng& rng, int levels) {
  LengthProblem p;
  p.ribs = 2;
  p.levels = levels;
  p.neighbourWeight = static_cast<float>(rng.uniform(0.1, 3));
  p.neighbourFreedom = static_cast<float>(rng.uniform(0, 0.6));
  p.neighbourCap = static_cast<float>(rng.uniform(0.5, 6));
  p.left.spacing = {static_cast<float>(rng.uniform(0.5, 30))};
  for (int rib = 0; rib < 2; ++rib) {
    double place = rng.uniform(0, 5);
    for (int k = 0; k < levels; ++k) {
      p.left.place.push_back(static_cast<float>(place));
      p.left.unary.push_back(rng.uniform() < 0.2 ? kUnreachable : static_cast<float>(rng.uniform(-2, 2)));
      place += rng.uniform(0.1, 2);
    }
  }
  p.right = p.left;
  return p;
}

std::vector<float> asRows(const LengthProblem& p, StepWay way, const std::vector<float>& in) {
  const MinPlusStep step = way == StepWay::Forwards ? stepTo(p, p.left, 1) : stepFrom(p, p.left, 1);
  std::vector<float> out(in.size());
  StepScratch scratch;
  convolveRows(step, {p.levels, p.levels, 1}, in.data(), out.data(), scratch);
  return out;
}

}  // namespace

TEST_CASE("a line of costs steps as rows of one column do, to the last bit, whatever came before") {
  Rng rng(20261123);
  LengthWorkspace workspace;
  for (int round = 0; round < 300; ++round) {
    const LengthProblem p = twoRibs(rng, 2 + static_cast<int>(rng.uniform(0, 40)));
    const std::vector<float> in(p.left.unary.begin(), p.left.unary.begin() + p.levels);
    for (const StepWay way : {StepWay::Forwards, StepWay::Backwards}) {
      std::vector<float> out(in.size());
      MinPlusLine(p, p.left, way, workspace).step(1, {in.data(), out.data()});
      CHECK(out == asRows(p, way, in));
    }
  }
}

TEST_CASE("a line of costs steps as its neighbour costs say") {
  Rng rng(20261124);
  LengthWorkspace workspace;
  for (int round = 0; round < 100; ++round) {
    const LengthProblem p = twoRibs(rng, 33);
    std::vector<float> out(33);
    MinPlusLine(p, p.left, StepWay::Forwards, workspace).step(1, {p.left.unary.data(), out.data()});
    for (std::size_t k = 0; k < out.size(); ++k) {
      float least = kUnreachable;
      for (std::size_t q = 0; q < out.size(); ++q) {
        const float cost = neighbourCost(p, p.left.place[q], p.left.place[33 + k], p.left.spacing[0]);
        least = std::min(least, p.left.unary[q] + cost);
      }
      CHECK(out[k] == doctest::Approx(least).epsilon(1e-4));
    }
  }
}

TEST_CASE("columns of costs step side by side as each does alone") {
  Rng rng(20261125);
  StepScratch scratch;
  for (int round = 0; round < 120; ++round) {
    const LengthProblem p = twoRibs(rng, 2 + static_cast<int>(rng.uniform(0, 40)));
    const MinPlusStep step = stepTo(p, p.left, 1);
    const auto levels = static_cast<std::size_t>(p.levels);
    for (const std::size_t width : {std::size_t{3}, std::size_t{4}, std::size_t{8}, std::size_t{12}, std::size_t{16}}) {
      std::vector<float> in, out(levels * width);
      for (std::size_t i = 0; i < levels * width; ++i)
        in.push_back(rng.uniform() < 0.2 ? kUnreachable : static_cast<float>(rng.uniform(-2, 2)));
      convolveRows(step, {p.levels, p.levels, static_cast<int>(width)}, in.data(), out.data(), scratch);
      for (std::size_t column = 0; column < width; ++column) {
        std::vector<float> one, alone(levels), here;
        for (std::size_t k = 0; k < levels; ++k) {
          one.push_back(in[k * width + column]);
          here.push_back(out[k * width + column]);
        }
        convolveRows(step, {p.levels, p.levels, 1}, one.data(), alone.data(), scratch);
        CHECK(here == alone);
      }
    }
  }
}
