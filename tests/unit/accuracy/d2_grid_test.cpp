#include "tests/bench/accuracy/d2_grid.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "engine/ribs/field/d2.h"
#include "tests/unit/ribs/fixtures.h"

using namespace spineloft;
using namespace spineloft::accuracy;
using namespace spineloft::ribs;
using fixtures::Points;

namespace {

// A waved spiral of `count` points that fills the middle of a grid of 300 × 300.
Points spiral(int count, double waves) {
  Points p;
  for (int i = 0; i < count; ++i) {
    const double turn = 3.2 * std::numbers::pi * i / (count - 1);
    const double radius = 40 + 8 * turn + 6 * std::sin(waves * turn);
    p.push_back({150 + radius * std::cos(turn), 150 + radius * std::sin(turn)});
  }
  return p;
}

bool beyond(const Points& p, PicturePoint x, double away) {
  for (PicturePoint q : p) {
    if (distance(q, x) < away) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("d2 on a grid is d2 at its points") {
  Rng rng(71);
  for (int round = 0; round < 8; ++round) {
    const Points p = fixtures::wander(rng, 2 + rng.below(200), 3);
    const D2Field field(p);
    const GridPlan plan{{rng.uniform(0, 400), rng.uniform(0, 400)}, rng.uniform(0.5, 8), 37, 21};
    std::vector<float> d2;
    d2OnGrid(p, plan, d2);
    REQUIRE(d2.size() == 37 * 21);
    for (int i = 0; i < 37 * 21; i += 5) {
      const PicturePoint x = plan.first + PicturePoint{plan.step * (i % 37), plan.step * (i / 37)};
      if (!beyond(p, x, 3)) continue;
      CHECK(static_cast<double>(d2[static_cast<std::size_t>(i)]) == doctest::Approx(field.distance(x)).epsilon(3e-5));
    }
  }
}

TEST_CASE("the hierarchical d2 of the paper's test is within 1e-3 of the exact one, for a hundredth") {
  const GridPlan plan{{0, 0}, 1, 300, 300};
  for (double waves : {0.0, 7.0, 11.0}) {
    const Points p = spiral(2000, waves);
    std::vector<float> exact, quick;
    const GridWork full = d2OnGrid(p, plan, exact), work = quickD2OnGrid(p, plan, quick);
    double worst = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
      worst = std::max(worst, std::abs(static_cast<double>(quick[i] / exact[i]) - 1));
    }
    CHECK(worst < 1e-3);
    CHECK(full.segments == 1999ull * 90000);
    CHECK(100 * (work.segments + work.groups) < full.segments);
  }
}

TEST_CASE("the hierarchical d2 keeps its promise on any line and grid, also on grids off the line") {
  Rng rng(72);
  double worst = 0;
  for (int round = 0; round < 40; ++round) {
    const Points p = fixtures::wander(rng, 2 + rng.below(400), rng.uniform(0.5, 20));
    const GridPlan plan{{rng.uniform(-300, 600), rng.uniform(-300, 600)},
                        rng.uniform(0.3, 6),
                        1 + static_cast<int>(rng.below(150)),
                        1 + static_cast<int>(rng.below(150))};
    const double length = D2Field(p).length();
    std::vector<float> exact, quick;
    d2OnGrid(p, plan, exact);
    quickD2OnGrid(p, plan, quick);
    REQUIRE(quick.size() == exact.size());
    for (std::size_t i = 0; i < exact.size(); ++i) {
      CHECK(std::isfinite(quick[i]));
      // Beyond about a pixel of the line: nearer, single precision is the limit of both.
      if (radiusOfD2(static_cast<double>(exact[i]), length) > 1)
        worst = std::max(worst, std::abs(static_cast<double>(quick[i] / exact[i]) - 1));
    }
  }
  CHECK(worst < 2.5e-3);
}

TEST_CASE("a grid point on the line has d2 0") {
  const Points p{{0, 10}, {40, 10}};
  for (const auto of : {d2OnGrid, quickD2OnGrid}) {
    std::vector<float> d2;
    of(p, {{5, 10}, 1, 10, 1}, d2);
    for (float v : d2) CHECK(v == 0);
  }
}
