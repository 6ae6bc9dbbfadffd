// Strictly convex quadratic programs with few rows that bind among many that might.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "engine/base/result.h"

namespace spineloft::geometry {

/// One coefficient of a row.
struct QpTerm {
  std::uint32_t unknown = 0;
  double value = 0;
};

/// Σ value · z[unknown] ≥ least, or = least. Each unknown at most once; at least one coefficient that is not 0.
struct QpRow {
  std::vector<QpTerm> terms;
  double least = 0;
  std::uint32_t group = 0;  ///< rows of one cause: one slack for all, named together
  bool equal = false;
};

/// An entry of the lower triangle of the energy: column ≤ row; entries of the same place add up.
struct QpEntry {
  std::uint32_t row = 0, column = 0;
  double value = 0;
};

/// min ½ zᵀHz + hᵀz subject to rows. H is positive definite.
struct Qp {
  std::size_t unknowns = 0;
  std::vector<QpEntry> energy;  ///< H
  std::vector<double> linear;   ///< h, one an unknown
  std::vector<QpRow> rows;
  /// More rows, asked for when all known ones hold: those that z breaks, the worst of each cause will do. None: no more
  /// are added. Rows that z does not break cost time and change nothing.
  std::function<std::vector<QpRow>(std::span<const double> z)> more = {};
};

struct QpOptions {
  double tolerance = 1e-7;                    ///< a row holds when it is broken by no more, in units of its least
  double slackCost = 1e6;                     ///< κ of ½ κ s² for the slack s of a group whose rows cannot all hold
  std::span<const std::uint32_t> start = {};  ///< rows that bound in a program like this one: tried first
  /// Σ multipliers of a group beyond which it counts as one of a contradiction: what is all but impossible costs as
  /// much, and is lost in rounding.
  double mostForce = std::numeric_limits<double>::infinity();
};

struct QpSolution {
  std::vector<double> z;
  std::vector<QpRow> rows;            ///< those given, then those that `more` gave
  std::vector<std::uint32_t> active;  ///< rows that bind: indices in `rows`
  std::vector<double> multipliers;    ///< of the active ones: Hz + h = Σ multiplier · row; ≥ 0 but for equal rows
  /// Groups that cannot all hold, growing; each got a slack, so that its rows hold but for that.
  std::vector<std::uint32_t> conflict;
  int rounds = 0;     ///< times that all rows were looked at
  double broken = 0;  ///< by how much a known row is broken, the most: rounding, or what kMostQpRounds left
};

/// The optimum, by the dual method of Goldfarb and Idnani (1983) on a sparse factor of H: from the minimum without
/// rows, broken rows become active one after the other, the worst of each group in a round, and rows whose multiplier
/// would fall below 0 leave. Finite; the same input gives the same result.
///
/// Rows that contradict each other are found by a ray of the dual, y ≥ 0 with Cᵀy = 0 and yᵀd > 0. The groups with more
/// than kNamedShare of Σy get one slack each, and the program is solved again; so do those beyond `mostForce`. Only
/// equal rows that contradict each other have no solution.
///
/// Errors: ValueOutOfRange for H that is not positive definite, values that are not finite, indices out of range, or
/// equal rows that cannot hold.
Result<QpSolution> solveQp(const Qp& program, const QpOptions& options = {});

inline constexpr double kNamedShare = 0.01;
inline constexpr int kMostQpRounds = 500;

}  // namespace spineloft::geometry
