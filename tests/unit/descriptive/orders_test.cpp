#include "engine/descriptive/orders.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/base/rng.h"
#include "engine/descriptive/order_search.h"
#include "engine/geometry/polygon.h"
#include "tests/support/rounds.h"
#include "tests/unit/descriptive/drawings.h"

using namespace spineloft;
using namespace spineloft::descriptive;
using namespace spineloft::testing;

namespace {

Orders ordersOf(const Drawing& drawing) {
  return descriptive::ordersOf(sheetsOf(drawing), drawing.orders, sizeOf(drawing.lines));
}

}  // namespace

TEST_CASE("orders that lines decide are those drawn, in discs that pass each other differently at different places") {
  std::size_t right = 0, wrong = 0, open = 0, tried = 0;
  for (const std::uint64_t seed : seeds(0, 80)) {
    ++tried;
    const Discs discs = randomDiscs(seed);
    // In a place of a few pixels nobody draws who is in front.
    if (std::ranges::any_of(discs.overlaps.all(), [](const Overlap& one) { return one.cells.size() < 16; })) continue;
    const Orders orders = ordersOf(drawingOf(discs));
    CHECK(orders.contradictions.empty());
    CHECK(orders.unexplained.empty());
    for (std::size_t k = 0; k < orders.orders.size(); ++k) {
      const Overlap& overlap = orders.overlaps.all()[k];
      const auto truth = discs.overlaps.at(overlap.a, overlap.b, overlap.at, 1);
      REQUIRE(truth);
      const bool same = (orders.orders[k].over == overlap.a) == bool(discs.aIsOver[*truth]);
      CHECK(orders.orders[k].kind == OrderKind::Over);
      if (orders.orders[k].from == OrderFrom::Guessed) {
        ++open;
      } else {
        ++(same ? right : wrong);
      }
    }
  }
  CHECK(wrong == 0);
  CHECK(2 * right > 5 * tried);
  CHECK(open * 8 < right);
}

TEST_CASE("three bars in a cycle over different places are no contradiction, and each is over the next") {
  for (const double turn : {0.0, 0.3, 1.1, 2.0}) {
    const Orders orders = ordersOf(barsInACycle(turn));
    CHECK(orders.contradictions.empty());
    REQUIRE(orders.orders.size() == 3);
    for (const Order& order : orders.orders) {
      CHECK((order.over + 1) % 3 == order.under);
      CHECK(order.from == OrderFrom::Drawn);
    }
  }
}

TEST_CASE("a woven mat has one order a crossing, over and under in turns, and indices of 0 and 1") {
  const Orders orders = ordersOf(wovenMat(4, PieceKind::Round));
  CHECK(orders.contradictions.empty());
  REQUIRE(orders.orders.size() == 16);
  for (std::size_t k = 0; k < 16; ++k) {
    const Overlap& overlap = orders.overlaps.all()[k];
    CHECK((orders.orders[k].over == overlap.a) == ((overlap.a + overlap.b - 4) % 2 == 0));
  }
  for (const OrderedStretch& stretch : orders.stretches) CHECK(stretch.index == (stretch.hidden ? 1 : 0));
}

TEST_CASE("a cycle in one place names exactly its pieces, and innocent ones keep their orders") {
  for (const std::uint64_t seed : seeds(0, 20)) {
    Rng rng(seed);
    // Three discs over one place, and two pairs elsewhere.
    std::vector<testing::Outline> outlines;
    const double first = rng.uniform(0, 6.28);
    for (int k = 0; k < 3; ++k) {
      const double angle = first + 2.0944 * k;
      outlines.push_back(ellipse({300 + 60 * std::cos(angle), 300 + 60 * std::sin(angle)}, 110, 110, 120));
    }
    for (const PicturePoint p : {PicturePoint{700, 300}, {780, 300}, {700, 700}, {760, 760}}) {
      outlines.push_back(ellipse(p, rng.uniform(60, 90), rng.uniform(60, 90), 120));
    }
    const Drawing drawing = drawn(
        outlines,
        [](std::uint32_t upper, std::uint32_t lower, PicturePoint) {
          return upper < 3 && lower < 3 ? (upper + 1) % 3 == lower : upper > lower;
        },
        PieceKind::Round);
    const Orders orders = ordersOf(drawing);
    REQUIRE(orders.contradictions.size() == 1);
    CHECK(orders.contradictions[0].pieces == std::vector<std::uint32_t>{0, 1, 2});
    CHECK(distance(orders.contradictions[0].at, {300, 300}) < 200);
    for (std::size_t k = 0; k < orders.orders.size(); ++k) {
      const Order& order = orders.orders[k];
      if (order.over >= 3) CHECK(order.over > order.under);
    }
  }
}

TEST_CASE("a given order wins over lines, which are then named") {
  Drawing drawing = barsInACycle();
  drawing.orders.push_back({1, 0, {500, 500}});
  const Orders orders = ordersOf(drawing);
  REQUIRE(orders.contradictions.size() == 1);
  CHECK(orders.contradictions[0].pieces == std::vector<std::uint32_t>{0, 1});
  CHECK(std::ranges::count(orders.orders, Order{1, 0, OrderKind::Over, OrderFrom::User}) == 1);
}

TEST_CASE("a line that becomes hidden away from crossings goes into what is round it") {
  const std::vector<testing::Outline> outlines{ellipse({400, 500}, 200, 200, 200),
                                               {{450, 470}, {800, 470}, {800, 530}, {450, 530}}};
  Drawing drawing =
      drawn(outlines, [](std::uint32_t upper, std::uint32_t, PicturePoint) { return upper == 1; }, PieceKind::Round);
  // The arm is seen over the body and dips into it at x = 520.
  const double whole = 2 * 350 + 2 * 60, dip = 70;
  drawing.lines[1].hidden = {{0, dip / whole}, {(760 - dip) / whole, 1}};
  const Orders orders = ordersOf(drawing);
  CHECK(orders.contradictions.empty());
  REQUIRE(orders.orders.size() == 1);
  CHECK(orders.orders[0].kind == OrderKind::Inside);
  CHECK(orders.orders[0].over == 0);
  CHECK(orders.orders[0].under == 1);
  CHECK(std::ranges::any_of(orders.stretches, [](const OrderedStretch& one) { return one.index == 0.5; }));
}

TEST_CASE("hidden with nothing in front of it is named") {
  Drawing drawing =
      drawn({ellipse({500, 500}, 200, 200, 100)}, [](auto, auto, auto) { return false; }, PieceKind::Round);
  drawing.lines[0].hidden = {{0.1, 0.5}};
  const Orders orders = ordersOf(drawing);
  CHECK(orders.orders.empty());
  CHECK(orders.unexplained.size() == 1);
}

TEST_CASE("choices are those of all assignments, and what is broken cannot be kept") {
  std::size_t contradictions = 0;
  for (const std::uint64_t seed : seeds(0, 400)) {
    Rng rng(seed);
    const std::uint32_t n = 2 + rng.below(7), m = 2 + rng.below(22);
    std::vector<Clause> clauses;
    for (std::uint32_t c = 0; c < m; ++c) {
      Clause clause{{}, 1 + std::floor(rng.uniform(0, 9))};
      const std::uint32_t width = 1 + rng.below(3);
      for (std::uint32_t k = 0; k < width; ++k) clause.literals.push_back({rng.below(n), rng.uniform() < 0.5});
      clauses.push_back(std::move(clause));
    }
    const ChoiceResult result = chooseAll(clauses, std::vector<bool>(n, true));
    const auto holds = [&](std::size_t clause, std::uint32_t values) {
      return std::ranges::any_of(clauses[clause].literals,
                                 [&](Literal l) { return ((values >> l.variable) & 1u) == (l.value ? 1u : 0u); });
    };
    const auto somewhere = [&](const std::vector<std::size_t>& wanted) {
      for (std::uint32_t values = 0; values < (1u << n); ++values) {
        if (std::ranges::all_of(wanted, [&](std::size_t c) { return holds(c, values); })) return true;
      }
      return false;
    };
    std::uint32_t chosen = 0;
    for (std::uint32_t v = 0; v < n; ++v) chosen |= (result.choices[v].value ? 1u : 0u) << v;
    std::vector<std::size_t> kept;
    for (std::size_t c = 0; c < m; ++c) {
      if (std::ranges::none_of(result.broken, [&](const BrokenClause& b) { return b.clause == c; })) kept.push_back(c);
    }
    for (const std::size_t c : kept) CHECK(holds(c, chosen));
    std::vector<std::size_t> all(m);
    for (std::size_t c = 0; c < m; ++c) all[c] = c;
    CHECK(result.broken.empty() == somewhere(all));
    for (const BrokenClause& broken : result.broken) {
      std::vector<std::size_t> with = broken.against;
      with.push_back(broken.clause);
      CHECK_FALSE(somewhere(with));
      for (std::size_t leave = 0; leave < broken.against.size(); ++leave) {
        std::vector<std::size_t> less = with;
        less.erase(less.begin() + static_cast<std::ptrdiff_t>(leave));
        CHECK(somewhere(less));
      }
      ++contradictions;
    }
  }
  CHECK(contradictions > 50);
}
