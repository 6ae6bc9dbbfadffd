// The upright box round points of a plane.
#pragma once

#include <algorithm>
#include <span>

namespace spineloft::geometry {

template <class V>
struct Bounds {
  V low, high;
  V middle() const { return (low + high) / 2; }
};

/// Of one point or more.
template <class V>
Bounds<V> boundsOf(std::span<const V> points) {
  Bounds<V> out{points.front(), points.front()};
  for (const V p : points) {
    out.low = {std::min(out.low.x, p.x), std::min(out.low.y, p.y)};
    out.high = {std::max(out.high.x, p.x), std::max(out.high.y, p.y)};
  }
  return out;
}

}  // namespace spineloft::geometry
