// Open polylines in a plane: length, even resampling, smoothing, nearest points, self-crossings.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/vec.h"

namespace spineloft::geometry {

/// Arc length at every point, starting with 0, into `s`, whose memory is reused. Same size as `points`.
template <class V>
void arcLengths(std::span<const V> points, std::vector<double>& s) {
  s.assign(points.size(), 0.0);
  for (std::size_t i = 1; i < points.size(); ++i) s[i] = s[i - 1] + distance(points[i - 1], points[i]);
}
template <class V>
std::vector<double> arcLengths(std::span<const V> points) {
  std::vector<double> s;
  arcLengths(points, s);
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

/// `count` ≥ 2 points evenly spaced by arc length, first and last kept exactly, into `out`, which `points` are
/// no part of. `s` is memory, for their arc lengths.
template <class V>
void resample(std::span<const V> points, std::size_t count, std::vector<double>& s, std::vector<V>& out) {
  arcLengths(points, s);
  out.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    out[i] =
        pointAt(points, std::span<const double>(s), s.back() * static_cast<double>(i) / static_cast<double>(count - 1));
  }
  if (count >= 2) {
    out.front() = points.front();
    out.back() = points.back();
  }
}
template <class V>
std::vector<V> resample(std::span<const V> points, std::size_t count) {
  std::vector<double> s;
  std::vector<V> out;
  resample(points, count, s, out);
  return out;
}

/// Drops points closer than `tolerance` to their predecessor (first kept; ≥ 1 point in, ≥ 1 out).
template <class V>
void dropRepeats(std::vector<V>& points, double tolerance) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (kept == 0 || distance(points[kept - 1], points[i]) > tolerance) points[kept++] = points[i];
  }
  points.resize(kept);
}
template <class V>
std::vector<V> dropRepeats(std::span<const V> points, double tolerance) {
  std::vector<V> out(points.begin(), points.end());
  dropRepeats(out, tolerance);
  return out;
}

/// The place of a segment, which may be a point itself, nearest to p.
template <class V>
V nearestOnSegment(V p, V a, V b) {
  const V along = b - a;
  const double squared = dot(along, along);
  const double t = squared > 0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
  return a + along * t;
}
/// From a point to a segment.
template <class V>
double distanceToSegment(V p, V a, V b) {
  return distance(p, nearestOnSegment(p, a, b));
}

/// Marks as `kept` what is farther than `tolerance` from the straight way between what is kept (Douglas and Peucker
/// 1973). `spans`: stretches between two places that are kept, as indices; beyond the last point they go on from the
/// first.
template <class V>
void keepFarther(std::span<const V> points, std::vector<std::array<std::size_t, 2>> spans, double tolerance,
                 std::vector<bool>& kept) {
  const std::size_t n = points.size();
  while (!spans.empty()) {
    const auto [from, to] = spans.back();
    spans.pop_back();
    double most = tolerance;
    std::size_t at = from;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double off = distanceToSegment(points[i % n], points[from % n], points[to % n]);
      if (off > most) {
        most = off;
        at = i;
      }
    }
    if (at == from) continue;
    kept[at % n] = true;
    spans.push_back({from, at});
    spans.push_back({at, to});
  }
}
/// Indices of as few points of the open line as leave all others within `tolerance` of it; both ends stay.
template <class V>
std::vector<std::size_t> keptPoints(std::span<const V> line, double tolerance) {
  std::vector<bool> kept(line.size(), false);
  if (!line.empty()) {
    kept.front() = kept.back() = true;
    keepFarther(line, {{0, line.size() - 1}}, tolerance, kept);
  }
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (kept[i]) out.push_back(i);
  }
  return out;
}
/// The open line of those points.
template <class V>
std::vector<V> simplifiedLine(std::span<const V> line, double tolerance) {
  std::vector<V> out;
  for (const std::size_t i : keptPoints(line, tolerance)) out.push_back(line[i]);
  return out;
}

/// Minimises Σ|x_i − p_i|² + (weight · second differences)², ends fixed: a discrete smoothing spline
/// that keeps straight lines straight. `points` evenly spaced; weight ≥ 0 in units of spacing².
std::vector<PicturePoint> smooth(std::span<const PicturePoint> points, double weight);
/// What it computes with.
struct SmoothMemory {
  std::vector<std::array<double, 3>> band;
  std::vector<PicturePoint> departure;
};
/// The same in place, in memory that is reused.
void smooth(std::vector<PicturePoint>& points, double weight, SmoothMemory& memory);

/// Where an open polyline first crosses itself: segments i < j (not neighbours) and the crossing.
struct Crossing {
  std::size_t first = 0, second = 0;
  PicturePoint at;
};
std::optional<Crossing> findCrossing(std::span<const PicturePoint> points);

}  // namespace spineloft::geometry
