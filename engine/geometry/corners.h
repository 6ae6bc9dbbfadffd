// Corners of closed lines.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "engine/geometry/polyline.h"

namespace spineloft::geometry {

/// A turn of this much within one spacing is a corner that sampling keeps, radians.
inline constexpr double kCorner = 0.7;

/// The point at a way along a closed line, which may go round. `closed`: its last point is its first; `s` its
/// arcLengths.
template <class V>
V onContour(std::span<const V> closed, std::span<const double> s, double at) {
  const double length = s.back();
  at = std::fmod(at, length);
  return pointAt(closed, s, at < 0 ? at + length : at);
}

/// Arc lengths of the corners, growing: where the line turns by kCorner within one spacing, the sharpest of its
/// neighbourhood.
template <class V>
std::vector<double> cornersOf(std::span<const V> closed, std::span<const double> s, double spacing) {
  const double w = std::min(spacing / 2, s.back() / 8);
  std::vector<std::pair<double, double>> turns;  // how sharp, where
  for (std::size_t i = 0; i + 1 < closed.size(); ++i) {
    const V in = closed[i] - onContour(closed, s, s[i] - w);
    const V out = onContour(closed, s, s[i] + w) - closed[i];
    const double turn = std::abs(std::atan2(cross(in, out), dot(in, out)));
    if (turn > kCorner) turns.push_back({turn, s[i]});
  }
  std::ranges::sort(turns, std::greater{});
  std::vector<double> corners;
  for (const auto& [turn, at] : turns) {
    const bool near = std::ranges::any_of(corners, [&](double other) {
      const double apart = std::abs(at - other);
      return std::min(apart, s.back() - apart) < spacing / 2;
    });
    if (!near) corners.push_back(at);
  }
  std::ranges::sort(corners);
  return corners;
}

}  // namespace spineloft::geometry
