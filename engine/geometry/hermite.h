// Cubics by values and slopes at two places, and slopes by neighbours.
#pragma once

namespace spineloft::geometry {

/// The cubic from p (t = 0) to q (t = 1) whose derivatives by t there are m and n. Numbers, points, vectors.
template <class V>
V hermite(const V& p, const V& q, const V& m, const V& n, double t) {
  const double u = 1 - t;
  return p * (u * u * (1 + 2 * t)) + m * (t * u * u) + q * (t * t * (3 - 2 * t)) - n * (t * t * u);
}

/// Derivative at b of the parabola through a, b and c, which lie `before` and `after` (> 0) apart.
template <class V>
V parabolaSlope(const V& a, const V& b, const V& c, double before, double after) {
  return ((b - a) * (after / before) + (c - b) * (before / after)) / (before + after);
}

/// The same at the end a.
template <class V>
V parabolaEndSlope(const V& a, const V& b, const V& c, double first, double second) {
  return (b - a) * (2 / first) - parabolaSlope(a, b, c, first, second);
}

}  // namespace spineloft::geometry
