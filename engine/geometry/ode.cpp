#include "engine/geometry/ode.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace spineloft::geometry {
namespace {

/// Solves `matrix` x = right for several right sides at once, both row by row, in place (Gauss, pivots by size).
/// Singular matrices do not occur.
void solve(std::vector<double>& matrix, std::vector<double>& right, std::size_t size, std::size_t sides) {
  for (std::size_t column = 0; column < size; ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column + 1; row < size; ++row) {
      if (std::abs(matrix[row * size + column]) > std::abs(matrix[pivot * size + column])) pivot = row;
    }
    const auto swapRows = [&](std::vector<double>& values, std::size_t width) {
      std::swap_ranges(&values[pivot * width], &values[pivot * width] + width, &values[column * width]);
    };
    if (pivot != column) {
      swapRows(matrix, size);
      swapRows(right, sides);
    }
    for (std::size_t row = 0; row < size; ++row) {
      if (row == column) continue;
      const double factor = matrix[row * size + column] / matrix[column * size + column];
      for (std::size_t k = column; k < size; ++k) matrix[row * size + k] -= factor * matrix[column * size + k];
      for (std::size_t k = 0; k < sides; ++k) right[row * sides + k] -= factor * right[column * sides + k];
    }
  }
  for (std::size_t row = 0; row < size; ++row) {
    for (std::size_t k = 0; k < sides; ++k) right[row * sides + k] /= matrix[row * size + row];
  }
}

/// The second derivative at the start of an interval is `rise` (end − start) − near · start slope − far · end slope,
/// by t; at the end it is the same mirrored.
struct Stiffness {
  double rise = 0, near = 0, far = 0;
};
Stiffness stiffnessOf(double tightness) {
  const double near = -OdeCurve({0, 0, 1, 0}, tightness).curvature(0);
  const double far = -OdeCurve({0, 0, 0, 1}, tightness).curvature(0);
  return {near + far, near, far};
}

}  // namespace

OdeCurve::OdeCurve(const OdeEnds& ends, double tightness) : tightness_(tightness), cubic_(tightness < kLeastTightness) {
  const auto& [a, b, m, n] = ends;
  if (cubic_) {
    c_ = {a, m, 3 * (b - a) - 2 * m - n, m + n - 2 * (b - a)};
    return;
  }
  // By symmetry about the middle the four equations are two pairs. With c2 = p + q and c3 = p − q:
  //   even: c0 + p (1 + e) = (a + b) / 2,  −λ p (1 − e) = (m − n) / 2
  //   odd:  −c1 / 2 + q (1 − e) = (a − b) / 2,  c1 − λ q (1 + e) = (m + n) / 2
  const double e = std::exp(-tightness), less = -std::expm1(-tightness);
  const double p = -(m - n) / (2 * tightness * less);
  const double q = ((a - b) + (m + n) / 2) / (2 * less - tightness * (1 + e));
  c_ = {(a + b) / 2 - p * (1 + e), (m + n) / 2 + tightness * q * (1 + e), p + q, p - q};
}

double OdeCurve::value(double t) const {
  if (cubic_) return c_[0] + t * (c_[1] + t * (c_[2] + t * c_[3]));
  return c_[0] + c_[1] * (t - 0.5) + c_[2] * std::exp(-tightness_ * t) + c_[3] * std::exp(-tightness_ * (1 - t));
}

double OdeCurve::slope(double t) const {
  if (cubic_) return c_[1] + t * (2 * c_[2] + t * 3 * c_[3]);
  return c_[1] + tightness_ * (c_[3] * std::exp(-tightness_ * (1 - t)) - c_[2] * std::exp(-tightness_ * t));
}

double OdeCurve::curvature(double t) const {
  if (cubic_) return 2 * c_[2] + t * 6 * c_[3];
  return tightness_ * tightness_ * (c_[2] * std::exp(-tightness_ * t) + c_[3] * std::exp(-tightness_ * (1 - t)));
}

RingCardinals::RingCardinals(std::span<const double> nodes, double tightness)
    : nodes_(nodes.begin(), nodes.end()), tightness_(tightness) {
  // At each node the second derivatives of both sides are equal: K equations for the K slopes.
  const std::size_t count = nodes_.size();
  std::vector<double> matrix(count * count, 0.0);
  slopes_.assign(count * count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = (i + count - 1) % count, after = (i + 1) % count;
    const double into = spanAfter(before), out = spanAfter(i);
    const Stiffness left = stiffnessOf(tightness_ * into), right = stiffnessOf(tightness_ * out);
    matrix[i * count + before] += left.far / into;
    matrix[i * count + i] += left.near / into + right.near / out;
    matrix[i * count + after] += right.far / out;
    slopes_[i * count + before] -= left.rise / (into * into);
    slopes_[i * count + i] += left.rise / (into * into) - right.rise / (out * out);
    slopes_[i * count + after] += right.rise / (out * out);
  }
  solve(matrix, slopes_, count, count);
}

double RingCardinals::spanAfter(std::size_t node) const {
  return node + 1 < nodes_.size() ? nodes_[node + 1] - nodes_[node] : nodes_.front() + 1 - nodes_.back();
}

void RingCardinals::at(double u, std::span<double> weights) const {
  u -= std::floor(u);
  const std::size_t count = nodes_.size();
  const auto next = static_cast<std::size_t>(std::ranges::upper_bound(nodes_, u) - nodes_.begin());
  const std::size_t from = (next + count - 1) % count, to = next % count;
  const double length = spanAfter(from), away = u - nodes_[from], t = (away < 0 ? away + 1 : away) / length;
  for (std::size_t k = 0; k < count; ++k) {
    const OdeEnds ends{from == k ? 1.0 : 0.0, to == k ? 1.0 : 0.0, slopes_[from * count + k] * length,
                       slopes_[to * count + k] * length};
    weights[k] = OdeCurve(ends, tightness_ * length).value(t);
  }
}

double aroundFour(const std::array<double, 4>& values, double x, double y) {
  const double turned = std::atan2(y, x) * 2 / std::numbers::pi + 4, whole = std::floor(turned), t = turned - whole;
  const auto quarter = static_cast<std::size_t>(whole);
  const double a = values[quarter % 4], b = values[(quarter + 1) % 4];
  return a + (b - a) * t * t * (3 - 2 * t);
}

}  // namespace spineloft::geometry
