// Open polylines in a plane: length, even resampling, smoothing, nearest points, self-crossings.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/base/vec.h"

namespace spineloft::geometry {

/// Arc length at every point, starting with 0. Same size as `points`.
template <class V>
std::vector<double> arcLengths(std::span<const V> points) {
  std::vector<double> s(points.size(), 0.0);
  for (std::size_t i = 1; i < points.size(); ++i) s[i] = s[i - 1] + distance(points[i - 1], points[i]);
  return s;
}

/// The point at arc length `at` (clamped to the ends). `s` = arcLengths(points); ≥ 1 point.
template <class V>
V pointAt(std::span<const V> points, std::span<const double> s, double at) {
  if (at <= s.front()) return points.front();
  if (at >= s.back()) return points.back();
  std::size_t low = 0, high = s.size() - 1;
  while (high - low > 1) {
    const std::size_t mid = (low + high) / 2;
    (s[mid] <= at ? low : high) = mid;
  }
  const double step = s[high] - s[low];
  return step > 0 ? lerp(points[low], points[high], (at - s[low]) / step) : points[low];
}

/// `count` ≥ 2 points evenly spaced by arc length, first and last kept exactly.
template <class V>
std::vector<V> resample(std::span<const V> points, std::size_t count) {
  const std::vector<double> s = arcLengths(points);
  std::vector<V> out(count);
  for (std::size_t i = 0; i < count; ++i) {
    out[i] = pointAt(points, std::span<const double>(s),
                     s.back() * static_cast<double>(i) / static_cast<double>(count - 1));
  }
  if (count >= 2) {
    out.front() = points.front();
    out.back() = points.back();
  }
  return out;
}

/// Drops points closer than `tolerance` to their predecessor (first kept; ≥ 1 point in, ≥ 1 out).
template <class V>
std::vector<V> dropRepeats(std::span<const V> points, double tolerance) {
  std::vector<V> out;
  out.reserve(points.size());
  for (const V& p : points) {
    if (out.empty() || distance(out.back(), p) > tolerance) out.push_back(p);
  }
  return out;
}

/// Minimises Σ|x_i − p_i|² + (weight · second differences)², ends fixed: a discrete smoothing spline
/// that keeps straight lines straight. `points` evenly spaced; weight ≥ 0 in units of spacing².
std::vector<PicturePoint> smooth(std::span<const PicturePoint> points, double weight);

/// Where an open polyline first crosses itself: segments i < j (not neighbours) and the crossing.
struct Crossing {
  std::size_t first = 0, second = 0;
  PicturePoint at;
};
std::optional<Crossing> findCrossing(std::span<const PicturePoint> points);

}  // namespace spineloft::geometry
