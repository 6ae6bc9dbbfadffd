#include "tests/support/random_programs.h"

#include <utility>

#include "engine/base/rng.h"

namespace spineloft::testing {

RandomProgram randomProgram(std::uint64_t seed) {
  Rng rng(seed);
  const auto n = 2 + rng.below(14), rows = 1 + rng.below(24);
  RandomProgram out;
  Eigen::MatrixXd root(n, n);
  for (auto& value : root.reshaped()) value = rng.uniform(-1, 1);
  out.energy = root * root.transpose() + Eigen::MatrixXd::Identity(n, n) * rng.uniform(0.05, 1);
  out.linear = Eigen::VectorXd(n);
  Eigen::VectorXd inside(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    out.linear[i] = rng.uniform(-2, 2);
    inside[i] = rng.uniform(-1, 1);
  }
  out.qp.unknowns = n;
  out.qp.linear.assign(out.linear.begin(), out.linear.end());
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k <= i; ++k) out.qp.energy.push_back({i, k, out.energy(i, k)});
  }
  for (std::uint32_t r = 0; r < rows; ++r) {
    geometry::QpRow row;
    double there = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
      if (rng.uniform() < 0.4 && i > 0) continue;
      row.terms.push_back({i, rng.uniform(-1, 1)});
      there += row.terms.back().value * inside[i];
    }
    row.least = r < n / 2 ? there : there - rng.uniform();
    row.group = rng.below(6);
    if (r > 0 && rng.uniform() < 0.1) {
      row = out.qp.rows.back();
      for (geometry::QpTerm& term : row.terms) term.value *= 2;
      row.least *= 2;
    }
    out.qp.rows.push_back(std::move(row));
  }
  return out;
}

}  // namespace spineloft::testing
