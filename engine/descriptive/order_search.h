// Choices between two values that clauses of a drawing ask for: as many clauses as can hold together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace spineloft::descriptive {

struct Literal {
  std::uint32_t variable = 0;
  bool value = true;
  bool operator==(const Literal&) const = default;
};

/// At least one of its literals holds.
struct Clause {
  std::vector<Literal> literals;  ///< ≥ 1
  double weight = 0;              ///< what breaking it costs; kHard: it is never broken
};
inline constexpr double kHard = -1;

enum class ChoiceFrom : std::uint8_t { Clause, Propagation, Guess };

struct Choice {
  bool value = true;
  ChoiceFrom from = ChoiceFrom::Guess;
};

/// A clause that does not hold, and those of other clauses with a weight that together forbid it.
struct BrokenClause {
  std::size_t clause = 0;
  std::vector<std::size_t> against;  ///< none of them can be left out; growing
};

struct ChoiceResult {
  std::vector<Choice> choices;  ///< one a variable
  std::vector<BrokenClause> broken;
};

/// Unit propagation, then search with the shortest open clause first (Davis, Logemann and Loveland 1962); `guesses`,
/// one a variable, are tried first. When not all clauses hold, those with a weight are taken from the heaviest to the
/// lightest as far as they hold together with all before. Hard clauses must hold together. Deterministic; a search of
/// more than kMostDecisions counts as one without a result.
ChoiceResult chooseAll(std::span<const Clause> clauses, const std::vector<bool>& guesses);

inline constexpr int kMostDecisions = 20000;

}  // namespace spineloft::descriptive
