#include "engine/cli/ode_differences.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spineloft::cli {
namespace {

/// Factors of d_{i−2} … d_{i+2} at a spacing of 1/n, over n⁴.
struct Stencil {
  double far = 1, near = 0, here = 0;
};
Stencil stencilOf(double tightness, double n) {
  const double bent = tightness * tightness / (n * n);
  return {1, -4 - bent, 6 + 2 * bent};
}

/// Values with their two ghosts.
std::vector<double> withGhosts(std::span<const double> values, const geometry::OdeEnds& ends) {
  const double n = static_cast<double>(values.size() - 1);
  std::vector<double> all(values.begin(), values.end());
  all.insert(all.begin(), all[1] - 2 * ends.startSlope / n);
  all.push_back(all[all.size() - 2] + 2 * ends.endSlope / n);
  return all;
}

/// A matrix of five diagonals: entry(i, j) for |i − j| ≤ 2.
class FiveDiagonals {
 public:
  explicit FiveDiagonals(std::size_t size) : size_(size), entries_(5 * size, 0.0) {}
  double& entry(std::size_t i, std::size_t j) { return entries_[5 * i + (j + 2 - i)]; }

  /// Gauss without pivots: the matrix is positive definite.
  void solve(std::vector<double>& right) {
    for (std::size_t i = 0; i < size_; ++i) {
      for (std::size_t row = i + 1; row < std::min(i + 3, size_); ++row) {
        const double factor = entry(row, i) / entry(i, i);
        for (std::size_t k = i; k < std::min(i + 3, size_); ++k) entry(row, k) -= factor * entry(i, k);
        right[row] -= factor * right[i];
      }
    }
    for (std::size_t i = size_; i-- > 0;) {
      for (std::size_t k = i + 1; k < std::min(i + 3, size_); ++k) right[i] -= entry(i, k) * right[k];
      right[i] /= entry(i, i);
    }
  }

 private:
  std::size_t size_;
  std::vector<double> entries_;
};

}  // namespace

std::vector<double> differenceForces(std::span<const double> values, const geometry::OdeEnds& ends, double tightness) {
  const double n = static_cast<double>(values.size() - 1);
  const auto [far, near, here] = stencilOf(tightness, n);
  const std::vector<double> d = withGhosts(values, ends);
  std::vector<double> forces;
  for (std::size_t i = 2; i + 2 < d.size(); ++i) {
    forces.push_back((far * (d[i - 2] + d[i + 2]) + near * (d[i - 1] + d[i + 1]) + here * d[i]) * n * n * n * n);
  }
  return forces;
}

std::vector<double> differenceCurve(const geometry::OdeEnds& ends, double tightness, std::span<const double> forces) {
  const std::size_t inner = forces.size();
  const double n = static_cast<double>(inner + 1);
  const auto [far, near, here] = stencilOf(tightness, n);
  FiveDiagonals matrix(inner);
  std::vector<double> right;
  for (std::size_t i = 0; i < inner; ++i) {
    right.push_back(forces[i] / (n * n * n * n));
    const auto place = static_cast<std::ptrdiff_t>(i);
    for (std::ptrdiff_t off = -2; off <= 2; ++off) {
      const double factor = off == 0 ? here : std::abs(off) == 1 ? near : far;
      const std::ptrdiff_t at = place + off, last = static_cast<std::ptrdiff_t>(inner);
      if (at >= 0 && at < last) {
        matrix.entry(i, static_cast<std::size_t>(at)) += factor;
      } else if (at == -1) {
        right[i] -= factor * ends.start;
      } else if (at == last) {
        right[i] -= factor * ends.end;
      } else if (at < 0) {  // the ghost is d_1 − 2 slope / n
        matrix.entry(i, 0) += factor;
        right[i] += factor * 2 * ends.startSlope / n;
      } else {
        matrix.entry(i, inner - 1) += factor;
        right[i] -= factor * 2 * ends.endSlope / n;
      }
    }
  }
  matrix.solve(right);
  right.insert(right.begin(), ends.start);
  right.push_back(ends.end);
  return right;
}

std::vector<double> differenceRing(std::span<const RingNode> known, double tightness, std::size_t nodes) {
  const auto [far, near, here] = stencilOf(tightness, static_cast<double>(nodes));
  std::vector<double> matrix(nodes * nodes, 0.0), right(nodes, 0.0);
  for (std::size_t i = 0; i < nodes; ++i) {
    const auto add = [&](std::size_t off, double factor) { matrix[i * nodes + (i + off) % nodes] += factor; };
    add(0, here);
    for (const auto& [off, factor] : {std::pair<std::size_t, double>{1, near}, {2, far}}) {
      add(off, factor);
      add(nodes - off, factor);
    }
  }
  for (const auto& [at, value] : known) {
    std::fill_n(&matrix[at * nodes], nodes, 0.0);
    matrix[at * nodes + at] = 1;
    right[at] = value;
  }
  for (std::size_t column = 0; column < nodes; ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column; row < nodes; ++row) {
      if (std::abs(matrix[row * nodes + column]) > std::abs(matrix[pivot * nodes + column])) pivot = row;
    }
    std::swap_ranges(&matrix[pivot * nodes], &matrix[pivot * nodes] + nodes, &matrix[column * nodes]);
    std::swap(right[pivot], right[column]);
    for (std::size_t row = column + 1; row < nodes; ++row) {
      const double factor = matrix[row * nodes + column] / matrix[column * nodes + column];
      if (factor == 0) continue;
      for (std::size_t k = column; k < nodes; ++k) matrix[row * nodes + k] -= factor * matrix[column * nodes + k];
      right[row] -= factor * right[column];
    }
  }
  for (std::size_t row = nodes; row-- > 0;) {
    for (std::size_t k = row + 1; k < nodes; ++k) right[row] -= matrix[row * nodes + k] * right[k];
    right[row] /= matrix[row * nodes + row];
  }
  return right;
}

}  // namespace spineloft::cli
