#include "engine/ribs/labels/runner_up.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/base/rng.h"
#include "engine/ribs/search/ribs.h"
#include "tests/unit/ribs/fixtures.h"

using namespace spineloft;
using namespace spineloft::ribs;

TEST_CASE("confidence is 0 where another place costs the same and near 1 where none comes close") {
  std::vector<float> marginal(60, 20.f), along(60), support(60, 0.f);
  for (std::size_t i = 0; i < 60; ++i) along[i] = static_cast<float>(i);
  marginal[20] = 1;
  marginal[21] = 1;  // the same place
  CHECK(confidenceOf({marginal, along, support, 20}) > 0.99);
  marginal[40] = 1;
  CHECK(confidenceOf({marginal, along, support, 20}) == 0);
  marginal[40] = 2;
  CHECK(confidenceOf({marginal, along, support, 20}) == doctest::Approx(1 - std::exp(-1)));
}

TEST_CASE("other places stand on edges, best first, at most three, apart from all others") {
  Rng rng(12);
  std::vector<RunnerUp> memory;
  for (int round = 0; round < 200; ++round) {
    std::vector<float> marginal(80), along(80), support(80);
    for (std::size_t i = 0; i < 80; ++i) {
      marginal[i] = static_cast<float>(rng.uniform(0, 6));
      support[i] = static_cast<float>(rng.uniform());
      along[i] = (i ? along[i - 1] : 0) + static_cast<float>(rng.uniform(0.2, 3));
    }
    const int chosen = static_cast<int>(std::min_element(marginal.begin(), marginal.end()) - marginal.begin());
    std::vector<int> labels;
    for (const RunnerUp& rival : findRunnersUp({marginal, along, support, chosen}, memory))
      labels.push_back(rival.label);
    CHECK(labels.size() <= 3);
    CHECK(std::ranges::is_sorted(labels, {}, [&](int k) { return marginal[k]; }));
    labels.push_back(chosen);
    for (std::size_t a = 0; a + 1 < labels.size(); ++a) {
      CHECK(support[labels[a]] >= 0.4f);
      for (std::size_t b = a + 1; b < labels.size(); ++b) {
        CHECK(std::abs(along[labels[a]] - along[labels[b]]) > 0.1f * along[chosen]);
      }
    }
  }
}

TEST_CASE("where a thing has two outlines, the one that was not taken is offered") {
  // A bar within a bar: lines at 25 and 45 px to either side.
  const image::Size size{400, 300};
  const image::EdgeMap map = fixtures::mapOf(size, [](PicturePoint p) {
    const double away = std::abs(p.y - 150);
    return p.x > 40 && p.x < 360 && (std::abs(away - 25) < 1.5 || std::abs(away - 45) < 1.5);
  });
  const Spine spine = cleanSpine(fixtures::Points{{75, 150}, {325, 150}}, size, {.ribs = 60}).value();
  const auto set = traceRibs(spine, map, size, {}, Progress{});
  REQUIRE(set.ok());
  int offered = 0;
  for (const Rib& rib : set.value().ribs) {
    const double taken = std::abs(rib.left.y - 150), other = taken < 35 ? 45 : 25;
    for (int k = 0; k < rib.leftOthers.count; ++k) {
      if (std::abs(std::abs(rib.leftOthers.at[k].y - 150) - other) > 3.5) continue;
      ++offered;
      break;
    }
  }
  CHECK(offered > 20);  // of 60
}
