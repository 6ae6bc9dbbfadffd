#include "engine/descriptive/order_search.h"

#include <algorithm>
#include <numeric>
#include <optional>

namespace spineloft::descriptive {
namespace {

/// The values found so far, with a way back.
class Search {
 public:
  Search(std::span<const Clause> clauses, const std::vector<bool>& guesses) : all_(clauses), guesses_(guesses) {
    uses_.resize(guesses.size());
    in_.assign(clauses.size(), false);
    value_.assign(guesses.size(), kOpen);
    for (std::uint32_t c = 0; c < clauses.size(); ++c) {
      for (const Literal literal : clauses[c].literals) uses_[literal.variable].push_back(c);
    }
  }

  void setIn(std::size_t clause, bool in) { in_[clause] = in; }
  /// Values for which all clauses that are in hold; none when there are none.
  std::optional<std::vector<bool>> solve() {
    std::ranges::fill(value_, kOpen);
    trail_.clear();
    decisions_ = 0;
    if (!propagateAll() || !decide()) return std::nullopt;
    std::vector<bool> out;
    for (const char value : value_) out.push_back(value == kTrue);
    return out;
  }
  /// After propagation alone: which variables have a value.
  std::vector<bool> known() {
    std::ranges::fill(value_, kOpen);
    trail_.clear();
    propagateAll();
    std::vector<bool> out;
    for (const char value : value_) out.push_back(value != kOpen);
    return out;
  }

 private:
  static constexpr char kOpen = 0, kTrue = 1, kFalse = 2;

  bool holds(Literal literal) const { return value_[literal.variable] == (literal.value ? kTrue : kFalse); }
  void set(Literal literal) {
    value_[literal.variable] = literal.value ? kTrue : kFalse;
    trail_.push_back(literal.variable);
  }
  /// Sets what the clause asks for; false when it cannot hold.
  bool look(std::uint32_t clause) {
    const Literal* open = nullptr;
    int opens = 0;
    for (const Literal& literal : all_[clause].literals) {
      if (holds(literal)) return true;
      if (value_[literal.variable] != kOpen) continue;
      open = &literal;
      ++opens;
    }
    if (opens == 1) set(*open);
    return opens > 0;
  }
  bool propagateAll() {
    for (std::uint32_t c = 0; c < all_.size(); ++c) {
      if (in_[c] && !look(c)) return false;
    }
    return propagateFrom(0);
  }
  bool propagateFrom(std::size_t first) {
    for (std::size_t i = first; i < trail_.size(); ++i) {
      for (const std::uint32_t clause : uses_[trail_[i]]) {
        if (in_[clause] && !look(clause)) return false;
      }
    }
    return true;
  }
  /// The open variable of the shortest open clause, else the first open one.
  std::optional<std::uint32_t> nextVariable() const {
    std::optional<std::uint32_t> found;
    std::size_t shortest = SIZE_MAX;
    for (std::size_t c = 0; c < all_.size(); ++c) {
      if (!in_[c] || std::ranges::any_of(all_[c].literals, [&](Literal l) { return holds(l); })) continue;
      std::size_t opens = 0;
      std::uint32_t first = 0;
      for (const Literal literal : all_[c].literals) {
        if (value_[literal.variable] == kOpen && opens++ == 0) first = literal.variable;
      }
      if (opens > 0 && opens < shortest) {
        shortest = opens;
        found = first;
      }
    }
    for (std::uint32_t v = 0; !found && v < value_.size(); ++v) {
      if (value_[v] == kOpen) found = v;
    }
    return found;
  }
  bool decide() {
    struct Level {
      std::size_t trail;
      Literal tried;
      bool isLast;
    };
    std::vector<Level> levels;
    for (;;) {
      const std::optional<std::uint32_t> next = nextVariable();
      if (!next) return true;
      levels.push_back({trail_.size(), {*next, guesses_[*next]}, false});
      set(levels.back().tried);
      while (!propagateFrom(levels.back().trail)) {
        if (++decisions_ > kMostDecisions) return false;
        while (levels.back().isLast) {
          back(levels.back().trail);
          levels.pop_back();
          if (levels.empty()) return false;
        }
        Level& level = levels.back();
        back(level.trail);
        level.tried.value = !level.tried.value;
        level.isLast = true;
        set(level.tried);
      }
    }
  }
  void back(std::size_t size) {
    while (trail_.size() > size) {
      value_[trail_.back()] = kOpen;
      trail_.pop_back();
    }
  }

  std::span<const Clause> all_;
  const std::vector<bool>& guesses_;
  std::vector<std::vector<std::uint32_t>> uses_;
  std::vector<bool> in_;
  std::vector<char> value_;
  std::vector<std::uint32_t> trail_;
  int decisions_ = 0;
};

/// Takes clauses with a weight out of the search, heaviest last, as long as it has no result without them.
std::vector<std::size_t> coreOf(Search& search, const std::vector<std::size_t>& taken) {
  std::vector<std::size_t> core = taken;
  for (std::size_t i = taken.size(); i-- > 0;) {
    search.setIn(taken[i], false);
    if (search.solve()) {
      search.setIn(taken[i], true);
    } else {
      std::erase(core, taken[i]);
    }
  }
  for (const std::size_t clause : taken) search.setIn(clause, true);
  std::ranges::sort(core);
  return core;
}

}  // namespace

ChoiceResult chooseAll(std::span<const Clause> clauses, const std::vector<bool>& guesses) {
  Search search(clauses, guesses);
  ChoiceResult result;
  for (std::size_t c = 0; c < clauses.size(); ++c) search.setIn(c, true);
  std::optional<std::vector<bool>> values = search.solve();
  if (!values) {
    std::vector<std::size_t> order;
    for (std::size_t c = 0; c < clauses.size(); ++c) {
      search.setIn(c, clauses[c].weight == kHard);
      if (clauses[c].weight != kHard) order.push_back(c);
    }
    std::ranges::stable_sort(order, [&](auto a, auto b) { return clauses[a].weight > clauses[b].weight; });
    values = search.solve();
    std::vector<std::size_t> taken;
    for (const std::size_t clause : order) {
      search.setIn(clause, true);
      if (std::optional<std::vector<bool>> with = search.solve()) {
        values = std::move(with);
        taken.push_back(clause);
        continue;
      }
      result.broken.push_back({clause, coreOf(search, taken)});
      search.setIn(clause, false);
    }
  }
  const std::vector<bool> known = search.known();
  for (std::size_t v = 0; v < guesses.size(); ++v) {
    result.choices.push_back(
        {values ? bool((*values)[v]) : bool(guesses[v]), known[v] ? ChoiceFrom::Propagation : ChoiceFrom::Guess});
  }
  std::vector<bool> isBroken(clauses.size(), false);
  for (const BrokenClause& broken : result.broken) isBroken[broken.clause] = true;
  for (std::size_t c = 0; c < clauses.size(); ++c) {
    if (isBroken[c] || clauses[c].literals.size() != 1) continue;
    result.choices[clauses[c].literals[0].variable].from = ChoiceFrom::Clause;
  }
  return result;
}

}  // namespace spineloft::descriptive
