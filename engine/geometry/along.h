// Numbers that vary along a curve: a twist, a depth, a blend. Places are shares of its length, 0…1.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace spineloft::geometry {

/// The value at one place.
struct AlongPoint {
  double at = 0;     ///< 0…1
  double value = 0;  ///< in the unit of what varies
  bool operator==(const AlongPoint&) const = default;
};

/// A smooth curve through its points that overshoots none of them (monotone cubic, Fritsch and
/// Carlson 1980); constant before the first and after the last. Without points: a constant that its
/// reader knows. Points in order, at least kLeastStep apart.
struct AlongCurve {
  std::vector<AlongPoint> points;
  bool operator==(const AlongCurve&) const = default;
  bool empty() const { return points.empty(); }
};

inline constexpr std::size_t kMostAlongPoints = 32;
inline constexpr double kLeastStep = 1e-4;  ///< between neighbouring places

/// The value at `at` (clamped to 0…1); `fallback` for a curve without points.
double valueAt(const AlongCurve& curve, double at, double fallback);

/// All finite, in order and within 0…1, values within low…high, at most kMostAlongPoints.
bool isValid(const AlongCurve& curve, double low, double high);

}  // namespace spineloft::geometry
