#include "engine/geometry/qp.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/base/rng.h"
#include "tests/support/random_programs.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::geometry;
using namespace spineloft::testing;

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;
using Random = RandomProgram;

double along(const QpRow& row, const std::vector<double>& z) {
  double sum = 0;
  for (const QpTerm& term : row.terms) sum += term.value * z[term.unknown];
  return sum;
}

double objective(const Random& program, const std::vector<double>& z) {
  const Eigen::Map<const Vector> at(z.data(), static_cast<Eigen::Index>(z.size()));
  return 0.5 * at.dot(program.energy * at) + program.linear.dot(at);
}

/// Below the optimum, and as good as it where it has settled.
struct DualValue {
  double value = 0;
  bool settled = false;
};
/// Hildreth's method (1957): the dual by one coordinate after the other.
DualValue dualOptimum(const Random& program) {
  const auto m = static_cast<Eigen::Index>(program.qp.rows.size());
  Matrix rows = Matrix::Zero(m, program.energy.rows());
  Vector least(m);
  for (Eigen::Index r = 0; r < m; ++r) {
    const QpRow& row = program.qp.rows[static_cast<std::size_t>(r)];
    for (const QpTerm& term : row.terms) rows(r, term.unknown) = term.value;
    least[r] = row.least;
  }
  const Eigen::LLT<Matrix> factor(program.energy);
  const Vector z0 = factor.solve(-program.linear);
  const Matrix gram = rows * factor.solve(rows.transpose());
  const Vector missing = least - rows * z0;
  Vector y = Vector::Zero(m);
  bool settled = false;
  for (int sweep = 0; sweep < 20000 && !settled; ++sweep) {
    double change = 0;
    for (Eigen::Index r = 0; r < m; ++r) {
      const double next = std::max(0.0, y[r] + (missing[r] - gram.row(r).dot(y)) / gram(r, r));
      change = std::max(change, std::abs(next - y[r]));
      y[r] = next;
    }
    settled = change < 1e-12;
  }
  return {0.5 * program.linear.dot(z0) + missing.dot(y) - 0.5 * y.dot(gram * y), settled};
}

/// What is wrong with the conditions of Karush, Kuhn and Tucker, the most.
double wrongness(const Random& program, const QpSolution& solution) {
  const Eigen::Map<const Vector> z(solution.z.data(), static_cast<Eigen::Index>(solution.z.size()));
  Vector rest = program.energy * z + program.linear;
  double most = 0;
  for (std::size_t k = 0; k < solution.active.size(); ++k) {
    const QpRow& row = solution.rows[solution.active[k]];
    for (const QpTerm& term : row.terms) rest[term.unknown] -= solution.multipliers[k] * term.value;
    most = std::max({most, -solution.multipliers[k], std::abs(along(row, solution.z) - row.least)});
  }
  for (const QpRow& row : solution.rows) most = std::max(most, row.least - along(row, solution.z));
  return std::max(most, rest.cwiseAbs().maxCoeff());
}

Qp lineOf(std::size_t unknowns) {
  Qp qp;
  qp.unknowns = unknowns;
  qp.linear.assign(unknowns, 0);
  for (std::uint32_t i = 0; i < unknowns; ++i) qp.energy.push_back({i, i, 1});
  return qp;
}

}  // namespace

TEST_CASE("the optimum of 1,000 random programs is that of another method, and nothing is broken") {
  double mostBroken = 0, mostOff = 0;
  std::size_t binding = 0, programs = 0, settled = 0;
  for (const std::uint64_t seed : seeds(0, 1000)) {
    ++programs;
    const Random program = randomProgram(seed);
    const auto solved = solveQp(program.qp, {1e-9});
    REQUIRE(solved.ok());
    CHECK(solved.value().conflict.empty());
    binding += solved.value().active.size();
    const double value = objective(program, solved.value().z), whole = 1 + std::abs(value);
    const DualValue other = dualOptimum(program);
    mostBroken = std::max(mostBroken, wrongness(program, solved.value()));
    CHECK(value > other.value - 1e-6 * whole);
    if (!other.settled) continue;
    ++settled;
    mostOff = std::max(mostOff, std::abs(value - other.value) / whole);
  }
  CHECK(200 * settled >= 199 * programs);
  CHECK(binding > 2 * programs);
  CHECK(mostBroken < 1e-7);
  CHECK(mostOff < 1e-6);
}

TEST_CASE("rows that come when they are broken, and rows tried first, change nothing but the work") {
  for (const std::uint64_t seed : seeds(0, 200)) {
    Random program = randomProgram(seed);
    const auto whole = solveQp(program.qp, {1e-10});
    REQUIRE(whole.ok());
    Qp lazy = program.qp;
    lazy.rows.clear();
    lazy.more = [&](std::span<const double> z) {
      std::vector<QpRow> broken;
      const std::vector<double> at(z.begin(), z.end());
      for (const QpRow& row : program.qp.rows) {
        if (row.least - along(row, at) > 1e-10) broken.push_back(row);
      }
      return broken;
    };
    const auto later = solveQp(lazy, {1e-10});
    REQUIRE(later.ok());
    QpOptions warm{1e-10};
    warm.start = whole.value().active;
    const auto again = solveQp(program.qp, warm);
    REQUIRE(again.ok());
    CHECK(again.value().rounds <= whole.value().rounds);
    for (std::size_t i = 0; i < program.qp.unknowns; ++i) {
      CHECK(later.value().z[i] == doctest::Approx(whole.value().z[i]).epsilon(1e-7));
      CHECK(again.value().z[i] == doctest::Approx(whole.value().z[i]).epsilon(1e-7));
    }
  }
}

TEST_CASE("equal rows hold exactly, beside others") {
  for (const std::uint64_t seed : seeds(0, 200)) {
    Random program = randomProgram(seed);
    const auto free = solveQp(program.qp, {1e-10});
    REQUIRE(free.ok());
    // The first row, moved to the side where it holds, and held there.
    QpRow pinned = program.qp.rows[0];
    pinned.equal = true;
    pinned.least = along(pinned, free.value().z);
    program.qp.rows.push_back(pinned);
    const auto solved = solveQp(program.qp, {1e-10});
    REQUIRE(solved.ok());
    CHECK(std::abs(along(pinned, solved.value().z) - pinned.least) < 1e-9);
    // It holds at the optimum already, which therefore stays.
    CHECK(objective(program, solved.value().z) == doctest::Approx(objective(program, free.value().z)).epsilon(1e-7));
  }
}

TEST_CASE("three sheets in a cycle are named, two innocent pairs beside them are not") {
  for (const std::uint64_t seed : seeds(0, 20)) {
    Rng rng(seed);
    Qp qp = lineOf(8);
    for (double& value : qp.linear) value = rng.uniform(-1, 1);
    const double gap = rng.uniform(0.1, 1);
    const auto over = [&](std::uint32_t upper, std::uint32_t lower, std::uint32_t group) {
      qp.rows.push_back({{{upper, 1}, {lower, -1}}, gap, group, false});
    };
    over(0, 1, 10);
    over(3, 4, 20);
    over(1, 2, 11);
    over(4, 0, 21);
    over(2, 0, 12);
    over(5, 2, 22);
    const auto solved = solveQp(qp, {1e-9});
    REQUIRE(solved.ok());
    CHECK(solved.value().conflict == std::vector<std::uint32_t>{10, 11, 12});
    // All others hold.
    for (const QpRow& row : qp.rows) {
      if (row.group >= 20) CHECK(along(row, solved.value().z) >= row.least - 1e-8);
    }
    // Around the cycle the gaps sum to nothing: what is missing is shared out, and no more is given up.
    double missing = 0;
    for (const QpRow& row : qp.rows) {
      if (row.group < 20) missing += row.least - along(row, solved.value().z);
    }
    CHECK(missing == doctest::Approx(3 * gap));
  }
}

TEST_CASE(
    "a cycle that only an absurd value could part is named where there is a limit to force, and kept without one") {
  for (const std::uint64_t seed : seeds(0, 20)) {
    Rng rng(seed);
    constexpr double kHardly = 1e-3;  // how much the seventh unknown parts the cycle
    Qp qp = lineOf(7);
    for (double& value : qp.linear) value = rng.uniform(-1, 1);
    const double gap = rng.uniform(0.1, 1);
    qp.rows = {{{{0, 1}, {1, -1}}, gap, 10, false},
               {{{1, 1}, {2, -1}}, gap, 11, false},
               {{{2, 1}, {0, -1}, {6, kHardly}}, gap, 12, false},
               {{{3, 1}, {4, -1}}, gap, 20, false}};
    const auto kept = solveQp(qp, {1e-9});
    REQUIRE(kept.ok());
    CHECK(kept.value().conflict.empty());
    CHECK(kept.value().z[6] == doctest::Approx(3 * gap / kHardly));
    QpOptions limited{1e-9, 1e4};
    limited.mostForce = 15;
    const auto named = solveQp(qp, limited);
    REQUIRE(named.ok());
    CHECK(named.value().conflict == std::vector<std::uint32_t>{10, 11, 12});
    CHECK(std::abs(named.value().z[6]) < 0.1 * kept.value().z[6]);
    CHECK(along(qp.rows[3], named.value().z) >= gap - 1e-8);
    limited.mostForce = 1e9;  // more than any row needs
    CHECK(solveQp(qp, limited).value().z == kept.value().z);
  }
}

TEST_CASE("what is no program is refused") {
  Qp qp = lineOf(2);
  qp.rows.push_back({{{2, 1}}, 0, 0, false});
  CHECK(solveQp(qp).error() == Error::ValueOutOfRange);
  qp.rows = {{{{0, NAN}}, 0, 0, false}};
  CHECK(solveQp(qp).error() == Error::ValueOutOfRange);
  qp.rows = {{{}, 0, 0, false}};
  CHECK(solveQp(qp).error() == Error::ValueOutOfRange);
  qp.rows = {{{{0, 1}}, 0, 0, true}, {{{0, 1}}, 1, 0, true}};
  CHECK(solveQp(qp).error() == Error::ValueOutOfRange);
  qp.rows.clear();
  qp.energy.push_back({1, 1, -3});
  CHECK(solveQp(qp).error() == Error::ValueOutOfRange);
}
