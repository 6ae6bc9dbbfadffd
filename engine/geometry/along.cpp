#include "engine/geometry/along.h"

#include <algorithm>
#include <cmath>

namespace spineloft::geometry {
namespace {

double slope(const AlongPoint& a, const AlongPoint& b) { return (b.value - a.value) / (b.at - a.at); }

/// Tangent at point i: the weighted harmonic mean of the slopes beside it, 0 at an extremum, so that
/// the cubic stays between its points; 0 at both ends.
double tangent(std::span<const AlongPoint> p, std::size_t i) {
  if (i == 0 || i + 1 == p.size()) return 0;
  const double before = slope(p[i - 1], p[i]), after = slope(p[i], p[i + 1]);
  if (before * after <= 0) return 0;
  const double left = p[i].at - p[i - 1].at, right = p[i + 1].at - p[i].at;
  const double first = 2 * right + left, second = right + 2 * left;
  return (first + second) / (first / before + second / after);
}

}  // namespace

double valueAt(const AlongCurve& curve, double at, double fallback) {
  const std::span<const AlongPoint> p(curve.points);
  if (p.empty()) return fallback;
  if (!(at > p.front().at)) return p.front().value;
  if (at >= p.back().at) return p.back().value;
  const auto next = std::ranges::upper_bound(p, at, {}, &AlongPoint::at);
  const auto j = static_cast<std::size_t>(next - p.begin()), i = j - 1;
  if (p.size() == 2) {  // a straight line needs no easing at its ends
    return p[0].value + slope(p[0], p[1]) * (at - p[0].at);
  }
  const double h = p[j].at - p[i].at, t = (at - p[i].at) / h;
  const double m0 = tangent(p, i) * h, m1 = tangent(p, j) * h;
  const double t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * p[i].value + (t3 - 2 * t2 + t) * m0 + (3 * t2 - 2 * t3) * p[j].value + (t3 - t2) * m1;
}

bool isValid(const AlongCurve& curve, double low, double high) {
  if (curve.points.size() > kMostAlongPoints) return false;
  double before = -1;
  for (const AlongPoint& p : curve.points) {
    // Written so that NaN fails.
    if (!(p.at >= 0 && p.at <= 1 && p.value >= low && p.value <= high)) return false;
    if (before >= 0 && p.at - before < kLeastStep) return false;
    before = p.at;
  }
  return true;
}

}  // namespace spineloft::geometry
