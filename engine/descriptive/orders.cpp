#include "engine/descriptive/orders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ranges>
#include <set>

#include "engine/descriptive/order_search.h"
#include "engine/descriptive/stretches.h"

namespace spineloft::descriptive {
namespace {

/// In a cell of more pieces only the first are looked at for cycles.
constexpr std::size_t kMostInCell = 12;

class Asker {
 public:
  Asker(std::span<const Sheet> sheets, std::span<const GivenOrder> given, Orders& orders)
      : sheets_(sheets), given_(given), orders_(orders) {
    within_.resize(overlaps().size());
  }

  void ask() {
    for (std::uint32_t i = 0; i < orders_.stretches.size(); ++i) askLine(i);
    double lines = 1;
    for (const Clause& clause : clauses_) lines += clause.weight;
    for (const GivenOrder& one : std::views::reverse(given_)) askUser(one, lines);
    cycles();
    const ChoiceResult result = chooseAll(clauses_, guesses());
    for (std::uint32_t k = 0; k < overlaps().size(); ++k) orders_.orders.push_back(orderOf(k, result.choices[k]));
    for (const std::uint32_t k : users_) {
      if (orders_.orders[k].from == OrderFrom::Drawn) orders_.orders[k].from = OrderFrom::User;
    }
    for (const BrokenClause& broken : result.broken) contradict(broken);
    settleInsides();
    indices();
  }

 private:
  const std::vector<Overlap>& overlaps() const { return orders_.overlaps.all(); }
  Literal over(std::uint32_t overlap, std::uint32_t piece) const { return {overlap, overlaps()[overlap].a == piece}; }
  PicturePoint middleOf(const OrderedStretch& stretch) const {
    return alongOutline(sheets_[stretch.piece].outlines[stretch.outline], (stretch.from + stretch.to) / 2);
  }

  void askLine(std::uint32_t index) {
    const OrderedStretch& stretch = orders_.stretches[index];
    const double length = stretch.to - stretch.from;
    for (const std::uint32_t k : stretch.at) within_[k][overlaps()[k].a == stretch.piece ? 0 : 1] += length;
    if (stretch.dips || (stretch.hidden && stretch.isVague)) return;
    Clause behind{{}, length};
    for (std::size_t k = 0; k < stretch.cover.size(); ++k) {
      if (stretch.hidden) {
        behind.literals.push_back(over(stretch.at[k], stretch.cover[k]));
      } else {
        add({{over(stretch.at[k], stretch.piece)}, length}, middleOf(stretch));
      }
    }
    if (!behind.literals.empty()) {
      add(std::move(behind), middleOf(stretch));
    } else if (stretch.hidden) {
      orders_.unexplained.push_back(index);
    }
  }
  void askUser(const GivenOrder& one, double weight) {
    const auto overlap = orders_.overlaps.nearest(one.over, one.under, one.at);
    if (!overlap || std::ranges::find(users_, *overlap) != users_.end()) return;
    users_.push_back(*overlap);
    add({{over(*overlap, one.over)}, weight}, overlaps()[*overlap].at);
  }
  void add(Clause clause, PicturePoint at) {
    clauses_.push_back(std::move(clause));
    places_.push_back(at);
  }
  /// No cycle of three in one place.
  void cycles() {
    std::set<std::array<std::uint32_t, 3>> triples;
    std::vector<std::uint32_t> last;
    for (std::uint32_t cell = 0; cell < orders_.overlaps.cells(); ++cell) {
      const auto in = orders_.overlaps.in(cell);
      const std::size_t n = std::min(in.size(), kMostInCell);
      if (n < 3) continue;
      const PicturePoint middle = orders_.overlaps.middle(cell);
      for (std::size_t a = 0; a < n; ++a) {
        for (std::size_t b = a + 1; b < n; ++b) {
          for (std::size_t c = b + 1; c < n; ++c) {
            triples.insert({*orders_.overlaps.at(in[a], in[b], middle, 0),
                            *orders_.overlaps.at(in[b], in[c], middle, 0),
                            *orders_.overlaps.at(in[a], in[c], middle, 0)});
          }
        }
      }
    }
    for (const auto& [ab, bc, ac] : triples) {
      add({{{ab, false}, {bc, false}, {ac, true}}, kHard}, {});
      add({{{ab, true}, {bc, true}, {ac, false}}, kHard}, {});
    }
  }
  std::vector<bool> guesses() const {
    std::vector<bool> out;
    for (const auto& [a, b] : within_) out.push_back(a > b * (1 + 1e-9));
    return out;
  }
  Order orderOf(std::uint32_t overlap, const Choice& choice) const {
    const Overlap& one = overlaps()[overlap];
    const OrderFrom from = choice.from == ChoiceFrom::Clause        ? OrderFrom::Drawn
                           : choice.from == ChoiceFrom::Propagation ? OrderFrom::Deduced
                                                                    : OrderFrom::Guessed;
    return {choice.value ? one.a : one.b, choice.value ? one.b : one.a, OrderKind::Over, from};
  }
  void contradict(const BrokenClause& broken) {
    std::set<std::uint32_t> pieces;
    const auto addPieces = [&](const Clause& clause) {
      for (const Literal literal : clause.literals) {
        pieces.insert({overlaps()[literal.variable].a, overlaps()[literal.variable].b});
      }
    };
    addPieces(clauses_[broken.clause]);
    for (const std::size_t clause : broken.against) addPieces(clauses_[clause]);
    const std::vector<std::uint32_t> names(pieces.begin(), pieces.end());
    // Both sides of a strip say the same.
    for (const Contradiction& known : orders_.contradictions) {
      if (known.pieces == names) return;
    }
    orders_.contradictions.push_back({names, places_[broken.clause]});
  }
  /// What dips goes into the frontmost of what is round it, unless an order is given there.
  void settleInsides() {
    for (OrderedStretch& stretch : orders_.stretches) {
      if (!stretch.dips) continue;
      std::size_t front = 0;
      for (std::size_t k = 1; k < stretch.cover.size(); ++k) {
        const auto between = orders_.overlaps.at(stretch.cover[front], stretch.cover[k], middleOf(stretch), 3);
        if (between && orders_.orders[*between].over == stretch.cover[k]) front = k;
      }
      Order& order = orders_.orders[stretch.at[front]];
      if (order.from == OrderFrom::User) continue;
      order = {stretch.cover[front], stretch.piece, OrderKind::Inside, order.from};
      stretch.index = 0.5;
    }
  }
  void indices() {
    for (OrderedStretch& stretch : orders_.stretches) {
      for (const std::uint32_t k : stretch.at) {
        const Order& order = orders_.orders[k];
        if (order.kind == OrderKind::Over && order.under == stretch.piece) stretch.index += 1;
      }
    }
  }

  std::span<const Sheet> sheets_;
  std::span<const GivenOrder> given_;
  Orders& orders_;
  std::vector<Clause> clauses_;
  std::vector<PicturePoint> places_;           ///< of each clause
  std::vector<std::array<double, 2>> within_;  ///< by overlap: length of the outlines of a and b within it
  std::vector<std::uint32_t> users_;           ///< overlaps with a given order
};

}  // namespace

Orders ordersOf(std::span<const Sheet> sheets, std::span<const GivenOrder> given, double size) {
  Orders orders;
  orders.overlaps = Overlaps(sheets, size);
  orders.stretches = stretchesOf(sheets, orders.overlaps, size);
  Asker(sheets, given, orders).ask();
  return orders;
}

}  // namespace spineloft::descriptive
