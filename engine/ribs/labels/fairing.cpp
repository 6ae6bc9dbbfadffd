#include "engine/ribs/labels/fairing.h"

#include <algorithm>
#include <numeric>

namespace spineloft::ribs {
namespace {

constexpr int kRounds = 4;
constexpr std::size_t kLeastEntries = 5;

double reweighted(double residual, double scale) {
  const double r = residual / scale;
  const double root = 1 / (1 + r * r);
  return root * root;
}

// A symmetric positive definite matrix with two bands on either side of its diagonal.
struct Pentadiagonal {
  std::vector<double>&diagonal, &first, &second;  // (i, i), (i, i + 1), (i, i + 2)

  Pentadiagonal(std::size_t n, FairingMemory& memory)
      : diagonal(memory.diagonal), first(memory.first), second(memory.second) {
    for (auto* band : {&diagonal, &first, &second}) band->assign(n, 0);
  }

  // Adds weight · (1, −2, 1)ᵀ(1, −2, 1) around row i.
  void addBend(std::size_t i, double weight) {
    diagonal[i - 1] += weight;
    diagonal[i] += 4 * weight;
    diagonal[i + 1] += weight;
    first[i - 1] -= 2 * weight;
    first[i] -= 2 * weight;
    second[i - 1] += weight;
  }

  // Solves in place by L D Lᵀ: the bands become L's, `x` the solution.
  void solve(std::vector<double>& x) {
    const std::size_t n = x.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (i > 0) diagonal[i] -= first[i - 1] * first[i - 1] * diagonal[i - 1];
      if (i > 1) diagonal[i] -= second[i - 2] * second[i - 2] * diagonal[i - 2];
      if (i > 0) first[i] -= first[i - 1] * second[i - 1] * diagonal[i - 1];
      first[i] /= diagonal[i];
      second[i] /= diagonal[i];
    }
    for (std::size_t i = 1; i < n; ++i) {
      x[i] -= first[i - 1] * x[i - 1] + (i > 1 ? second[i - 2] * x[i - 2] : 0);
    }
    for (std::size_t i = 0; i < n; ++i) x[i] /= diagonal[i];
    for (std::size_t i = n - 1; i-- > 0;) {
      x[i] -= first[i] * x[i + 1] + (i + 2 < n ? second[i] * x[i + 2] : 0);
    }
  }
};

}  // namespace

const std::vector<double>& fairLengths(const SideLengths& side, const FairingParams& params, FairingMemory& memory) {
  const std::vector<double>& z = side.length;
  const std::size_t n = z.size();
  std::vector<double>&x = memory.fair, &next = memory.next;
  x = z;
  const double mean = std::accumulate(z.begin(), z.end(), 0.0) / static_cast<double>(std::max<std::size_t>(1, n));
  if (n < kLeastEntries || !(params.stiffness > 0) || !(mean > 0)) return x;
  const double corner = params.corner * mean, outlier = params.outlier * mean;
  for (int round = 0; round < kRounds; ++round) {
    Pentadiagonal matrix(n, memory);
    next.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      const double weight = std::max(params.leastTrust, side.trust[i]) * reweighted(x[i] - z[i], outlier);
      matrix.diagonal[i] = weight;
      next[i] = weight * z[i];
    }
    for (std::size_t i = 1; i + 1 < n; ++i) {
      const double bend = x[i - 1] - 2 * x[i] + x[i + 1];
      matrix.addBend(i, params.stiffness * reweighted(bend, corner));
    }
    matrix.solve(next);
    x.swap(next);
  }
  return x;
}

}  // namespace spineloft::ribs
