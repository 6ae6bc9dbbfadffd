// How far a point is from a line of points.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>

#include "engine/geometry/polyline.h"

namespace spineloft::geometry {

/// From a point to the nearest place of a line; `closed`: the way from its last point to its first one counts as well.
/// Infinity for a line without points.
template <class V>
double distanceToLine(V p, std::span<const V> line, bool closed = false) {
  if (line.empty()) return std::numeric_limits<double>::infinity();
  double least = distanceToSegment(p, closed ? line.back() : line.front(), line.front());
  for (std::size_t i = 1; i < line.size(); ++i) least = std::min(least, distanceToSegment(p, line[i - 1], line[i]));
  return least;
}

}  // namespace spineloft::geometry
