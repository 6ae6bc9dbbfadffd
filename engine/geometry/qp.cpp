#include "engine/geometry/qp.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace spineloft::geometry {
namespace {

using Vector = Eigen::VectorXd;
using Factor = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower>;

/// A row depends on the active ones when less of it is left than this share of what its compliance is summed up from.
constexpr double kDependent = 1e-13;

double along(const QpRow& row, const Vector& z) {
  double sum = 0;
  for (const QpTerm& term : row.terms) sum += term.value * z[term.unknown];
  return sum;
}

/// The rows that bind, with what is known of them: H⁻¹ of each, G = C H⁻¹ Cᵀ and its Cholesky factor.
class ActiveSet {
 public:
  ActiveSet(const Factor& factor, const std::vector<QpRow>& rows, Eigen::Index unknowns)
      : factor_(factor), rows_(rows), unknowns_(unknowns) {}

  const std::vector<std::uint32_t>& members() const { return members_; }
  std::vector<double>& multipliers() { return multipliers_; }
  bool has(std::uint32_t row) const { return std::ranges::find(members_, row) != members_.end(); }

  /// H⁻¹ of a row; kept, since a row that leaves often comes back.
  const Vector& reach(std::uint32_t row) {
    const auto [at, isNew] = reaches_.try_emplace(row);
    if (!isNew) return at->second;
    Vector load = Vector::Zero(unknowns_);
    for (const QpTerm& term : rows_[row].terms) load[term.unknown] = term.value;
    return at->second = factor_.solve(load);
  }
  /// What the active rows do along H⁻¹ of `row`.
  Vector against(std::uint32_t row) {
    const Vector& y = reach(row);
    Vector out(static_cast<Eigen::Index>(members_.size()));
    for (std::size_t k = 0; k < members_.size(); ++k) out[static_cast<Eigen::Index>(k)] = along(rows_[members_[k]], y);
    return out;
  }
  /// G⁻¹ of it.
  Vector solve(Vector right) const {
    const auto n = right.size();
    const auto lower = lower_.topLeftCorner(n, n);
    lower.triangularView<Eigen::Lower>().solveInPlace(right);
    lower.triangularView<Eigen::Lower>().transpose().solveInPlace(right);
    return right;
  }
  void add(std::uint32_t row, double multiplier, const Vector& against, double own) {
    const auto n = static_cast<Eigen::Index>(members_.size());
    grow(n + 1);
    gram_.row(n).head(n) = against.transpose();
    gram_(n, n) = own;
    appendFactor(n);
    members_.push_back(row);
    multipliers_.push_back(multiplier);
  }
  void drop(std::size_t k) {
    const auto at = static_cast<Eigen::Index>(k), n = static_cast<Eigen::Index>(members_.size());
    for (Eigen::Index i = at; i + 1 < n; ++i) {
      gram_.row(i).head(at) = gram_.row(i + 1).head(at).eval();
      for (Eigen::Index j = at; j <= i; ++j) gram_(i, j) = gram_(i + 1, j + 1);
    }
    members_.erase(members_.begin() + at);
    multipliers_.erase(multipliers_.begin() + at);
    for (Eigen::Index i = at; i + 1 < n; ++i) appendFactor(i);
  }
  /// What the compliance left of a row is rounded with: √(own · G_kk) bounds each product of two rows.
  double roundingScale(double own, const Vector& rate) const {
    if (rate.size() == 0) return own;
    return own + rate.cwiseAbs().dot((own * gram_.diagonal().head(rate.size())).cwiseSqrt());
  }
  /// z₀ + Σ multiplier · H⁻¹ row.
  Vector point(const Vector& z0) {
    Vector z = z0;
    for (std::size_t k = 0; k < members_.size(); ++k) z += multipliers_[k] * reach(members_[k]);
    return z;
  }

 private:
  void grow(Eigen::Index n) {
    if (gram_.rows() >= n) return;
    const Eigen::Index size = std::max<Eigen::Index>(2 * gram_.rows(), 32);
    gram_.conservativeResize(size, size);
    lower_.conservativeResize(size, size);
  }
  /// Row n of the factor from row n of G and the rows before.
  void appendFactor(Eigen::Index n) {
    Vector row = gram_.row(n).head(n).transpose();
    lower_.topLeftCorner(n, n).triangularView<Eigen::Lower>().solveInPlace(row);
    lower_.row(n).head(n) = row.transpose();
    const double own = gram_(n, n);
    lower_(n, n) = std::sqrt(std::max(own - row.squaredNorm(), kDependent * own));
  }

  const Factor& factor_;
  const std::vector<QpRow>& rows_;
  Eigen::Index unknowns_;
  std::vector<std::uint32_t> members_;
  std::vector<double> multipliers_;
  std::map<std::uint32_t, Vector> reaches_;
  Eigen::MatrixXd gram_, lower_;
};

/// The method on one program; contradictions come out as a ray.
class DualMethod {
 public:
  DualMethod(const Factor& factor, const Qp& program, std::vector<QpRow> rows, double tolerance)
      : rows_(std::move(rows)),
        tolerance_(tolerance),
        active_(factor, rows_, static_cast<Eigen::Index>(program.unknowns)) {
    const Eigen::Map<const Vector> linear(program.linear.data(), static_cast<Eigen::Index>(program.linear.size()));
    z0_ = factor.solve(-linear);
  }

  std::vector<QpRow>& rows() { return rows_; }
  Vector point() { return active_.point(z0_); }

  /// Makes a row hold. Groups of a contradiction with their shares, when it cannot.
  std::optional<std::map<std::uint32_t, double>> hold(std::uint32_t row) {
    if (active_.has(row)) return std::nullopt;
    const QpRow& one = rows_[row];
    Vector against = active_.against(row);
    const double own = along(one, active_.reach(row));
    double missing = one.least - along(one, z0_);
    for (Eigen::Index k = 0; k < against.size(); ++k) missing -= against[k] * active_.multipliers()[at(k)];
    if (!one.equal && missing <= tolerance_) return std::nullopt;
    double multiplier = 0;
    ++steps_;
    for (;;) {
      const Vector rate = active_.solve(against);
      const double free = own - against.dot(rate);
      const double scale = active_.roundingScale(own, rate);
      const double whole = free > kDependent * scale ? missing / free : std::numeric_limits<double>::infinity();
      const auto [step, leaving] = longestStep(rate);
      if (std::isinf(whole) && (one.equal || leaving < 0)) {
        if (std::abs(missing) <= tolerance_) return std::nullopt;
        return contradiction(row, rate);
      }
      const double taken = one.equal ? whole : std::min(whole, step);
      for (Eigen::Index k = 0; k < rate.size(); ++k) active_.multipliers()[at(k)] -= taken * rate[k];
      multiplier += taken;
      if (taken == whole) break;
      missing -= std::isinf(whole) ? 0 : taken * free;
      active_.multipliers()[at(leaving)] = 0;
      active_.drop(at(leaving));
      const Eigen::Index rest = against.size() - 1 - leaving;
      against.segment(leaving, rest) = against.tail(rest).eval();
      against.conservativeResize(against.size() - 1);
    }
    active_.add(row, multiplier, against, own);
    return std::nullopt;
  }

  /// Multipliers anew from the active rows, without what rounding has added up.
  void refresh() {
    const std::vector<std::uint32_t>& members = active_.members();
    if (members.empty()) return;
    const Vector z = point();
    Vector off(static_cast<Eigen::Index>(members.size()));
    for (std::size_t k = 0; k < members.size(); ++k) {
      off[static_cast<Eigen::Index>(k)] = rows_[members[k]].least - along(rows_[members[k]], z);
    }
    const Vector change = active_.solve(off);
    for (std::size_t k = 0; k < members.size(); ++k) {
      active_.multipliers()[k] += change[static_cast<Eigen::Index>(k)];
    }
  }
  std::size_t steps() const { return steps_; }  ///< rows for which something was done
  const std::vector<std::uint32_t>& members() const { return active_.members(); }
  const std::vector<double>& multipliers() { return active_.multipliers(); }

 private:
  static std::size_t at(Eigen::Index k) { return static_cast<std::size_t>(k); }

  /// How far the multipliers of the active rows allow to go, and which of them stops it; −1: none.
  std::pair<double, Eigen::Index> longestStep(const Vector& rate) {
    double step = std::numeric_limits<double>::infinity();
    Eigen::Index leaving = -1;
    for (Eigen::Index k = 0; k < rate.size(); ++k) {
      if (rows_[active_.members()[at(k)]].equal || !(rate[k] > 0)) continue;
      const double here = active_.multipliers()[at(k)] / rate[k];
      if (here < step) {
        step = here;
        leaving = k;
      }
    }
    return {std::max(step, 0.0), leaving};
  }
  std::map<std::uint32_t, double> contradiction(std::uint32_t row, const Vector& rate) {
    std::map<std::uint32_t, double> share;
    if (!rows_[row].equal) share[rows_[row].group] = 1;
    double sum = rows_[row].equal ? 0 : 1;
    for (Eigen::Index k = 0; k < rate.size(); ++k) {
      const QpRow& other = rows_[active_.members()[at(k)]];
      if (other.equal) continue;
      sum += std::abs(rate[k]);
      share[other.group] += std::abs(rate[k]);
    }
    std::erase_if(share, [&](const auto& one) { return one.second <= kNamedShare * sum; });
    return share;
  }

  std::vector<QpRow> rows_;
  double tolerance_;
  ActiveSet active_;
  Vector z0_;
  std::size_t steps_ = 0;
};

bool isSound(const Qp& program, const QpRow& row) {
  bool some = false;
  for (const QpTerm& term : row.terms) {
    if (term.unknown >= program.unknowns || !std::isfinite(term.value)) return false;
    some = some || term.value != 0;
  }
  return some && std::isfinite(row.least);
}

/// One solution, or the groups of a contradiction.
struct Outcome {
  QpSolution solution;
  std::map<std::uint32_t, double> conflict;
};

/// The worst broken row of every group, worst first. What those that bind are off by is rounding.
std::vector<std::uint32_t> worstRows(const std::vector<QpRow>& rows, const std::vector<std::uint32_t>& binding,
                                     const Vector& z, double tolerance) {
  std::map<std::uint32_t, std::pair<double, std::uint32_t>> worst;
  std::vector<bool> skipped(rows.size(), false);
  for (const std::uint32_t row : binding) skipped[row] = true;
  for (std::uint32_t i = 0; i < rows.size(); ++i) {
    if (rows[i].equal || skipped[i]) continue;
    const double missing = rows[i].least - along(rows[i], z);
    if (!(missing > tolerance)) continue;
    const auto [at, isNew] = worst.try_emplace(rows[i].group, missing, i);
    if (!isNew && missing > at->second.first) at->second = {missing, i};
  }
  std::vector<std::pair<double, std::uint32_t>> sorted;
  for (const auto& [group, one] : worst) sorted.push_back(one);
  std::ranges::stable_sort(sorted, [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::uint32_t> out;
  for (const auto& [missing, row] : sorted) out.push_back(row);
  return out;
}

/// The groups whose rows push by more than `most`.
std::map<std::uint32_t, double> strained(const QpSolution& solution, double most) {
  std::map<std::uint32_t, double> force;
  for (std::size_t k = 0; k < solution.active.size(); ++k) {
    const QpRow& row = solution.rows[solution.active[k]];
    if (!row.equal) force[row.group] += solution.multipliers[k];
  }
  std::erase_if(force, [&](const auto& one) { return one.second <= most; });
  return force;
}

/// Runs the method on a program whose rows are sound.
Result<Outcome> run(const Qp& program, std::vector<QpRow> given, const QpOptions& options) {
  const auto n = static_cast<Eigen::Index>(program.unknowns);
  std::vector<Eigen::Triplet<double, int>> entries;
  entries.reserve(program.energy.size());
  for (const QpEntry& e : program.energy) {
    if (e.row >= program.unknowns || e.column > e.row || !std::isfinite(e.value)) return Error::ValueOutOfRange;
    entries.emplace_back(static_cast<int>(e.row), static_cast<int>(e.column), e.value);
  }
  Eigen::SparseMatrix<double> energy(n, n);
  energy.setFromTriplets(entries.begin(), entries.end());
  const Factor factor(energy);
  if (factor.info() != Eigen::Success || !(factor.vectorD().minCoeff() > 0)) return Error::ValueOutOfRange;

  DualMethod method(factor, program, std::move(given), options.tolerance);
  std::vector<std::uint32_t> first;
  for (std::uint32_t i = 0; i < method.rows().size(); ++i) {
    if (method.rows()[i].equal) first.push_back(i);
  }
  for (const std::uint32_t row : options.start) {
    if (row < method.rows().size() && !method.rows()[row].equal) first.push_back(row);
  }
  Outcome outcome;
  std::size_t steps = 0;
  for (int round = 0;; ++round) {
    for (const std::uint32_t row : first) {
      if (auto conflict = method.hold(row)) {
        outcome.conflict = std::move(*conflict);
        outcome.solution.rows = std::move(method.rows());
        return outcome;
      }
    }
    method.refresh();
    const Vector z = method.point();
    if (!z.allFinite()) return Error::ValueOutOfRange;
    outcome.solution.rounds = round + 1;
    first = worstRows(method.rows(), method.members(), z, options.tolerance);
    if (first.empty() && program.more) {
      for (QpRow& row : program.more({z.data(), program.unknowns})) {
        if (!isSound(program, row)) return Error::ValueOutOfRange;
        first.push_back(static_cast<std::uint32_t>(method.rows().size()));
        method.rows().push_back(std::move(row));
      }
    }
    // Where nothing was done for rows that seem broken, they are so by rounding.
    const bool stuck = (round > 0 && steps == method.steps()) || round + 1 == kMostQpRounds;
    steps = method.steps();
    if (!first.empty() && !stuck) continue;
    for (const QpRow& row : method.rows()) {
      outcome.solution.broken = std::max(outcome.solution.broken, row.least - along(row, z));
    }
    outcome.solution.z.assign(z.data(), z.data() + n);
    outcome.solution.active = method.members();
    outcome.solution.multipliers = method.multipliers();
    outcome.solution.rows = std::move(method.rows());
    return outcome;
  }
}

}  // namespace

Result<QpSolution> solveQp(const Qp& program, const QpOptions& options) {
  if (program.linear.size() != program.unknowns) return Error::ValueOutOfRange;
  for (const QpRow& row : program.rows) {
    if (!isSound(program, row)) return Error::ValueOutOfRange;
  }
  std::map<std::uint32_t, std::uint32_t> slackOf;  // by group: its unknown
  std::vector<QpRow> rows = program.rows;
  Qp wide{program.unknowns, program.energy, program.linear, {}, {}};
  const auto soften = [&](QpRow& row) {
    if (const auto slack = slackOf.find(row.group); slack != slackOf.end() && !row.equal) {
      row.terms.push_back({slack->second, 1.0});
    }
  };
  for (;;) {
    if (program.more) {
      wide.more = [&](std::span<const double> z) {
        std::vector<QpRow> found = program.more(z.first(program.unknowns));
        for (QpRow& row : found) soften(row);
        return found;
      };
    }
    Result<Outcome> outcome = run(wide, rows, options);
    if (!outcome) return outcome.failure();
    QpSolution& solution = outcome.value().solution;
    std::map<std::uint32_t, double>& conflict = outcome.value().conflict;
    if (conflict.empty()) {
      conflict = strained(solution, options.mostForce);
      std::erase_if(conflict, [&](const auto& one) { return slackOf.contains(one.first); });
    }
    if (conflict.empty() && !solution.z.empty()) {
      solution.z.resize(program.unknowns);
      for (const auto& [group, slack] : slackOf) solution.conflict.push_back(group);
      for (QpRow& row : solution.rows) {
        std::erase_if(row.terms, [&](const QpTerm& term) { return term.unknown >= program.unknowns; });
      }
      return std::move(solution);
    }
    // What was found on the way stays known; the groups of the contradiction may give way.
    rows = std::move(solution.rows);
    bool any = false;
    for (const auto& [group, share] : conflict) {
      if (!slackOf.try_emplace(group, static_cast<std::uint32_t>(wide.unknowns)).second) continue;
      any = true;
      const auto slack = static_cast<std::uint32_t>(wide.unknowns++);
      wide.energy.push_back({slack, slack, options.slackCost});
      wide.linear.push_back(0);
      for (QpRow& row : rows) {
        if (row.group == group && !row.equal) row.terms.push_back({slack, 1.0});
      }
    }
    if (!any) return Error::ValueOutOfRange;
  }
}

}  // namespace spineloft::geometry
