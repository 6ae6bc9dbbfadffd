#include "tests/bench/accuracy/algorithm_one.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>

#include "tests/unit/ribs/length_problems.h"

using namespace spineloft;
using namespace spineloft::accuracy;
using namespace spineloft::ribs;

TEST_CASE("the optimum's energy never exceeds that of the paper's Algorithm 1") {
  Rng rng(33);
  LengthWorkspace workspace;
  int strictlyBetter = 0;
  for (int round = 0; round < 12; ++round) {
    const LengthProblem p =
        round % 2 == 0 ? fixtures::pictureLikeProblem(40, 32, rng) : fixtures::randomProblem(25, 20, true, rng);
    const double ours = energyOf(p, optimalLabels(p, workspace)).total();
    const double theirs = energyOf(p, algorithmOne(p, {.seed = static_cast<std::uint64_t>(round)})).total();
    CHECK(std::isfinite(theirs));
    CHECK(ours <= theirs + 1e-4);
    strictlyBetter += ours < theirs - 1e-4 ? 1 : 0;
  }
  CHECK(strictlyBetter >= 10);
}
