// Cubic arcs through points, in the plane or in space, that are a circle where the points lie on one.
#pragma once

#include <algorithm>

#include "engine/base/vec.h"

namespace spineloft::geometry {

/// Unit tangent at p of the circle through a, p, b (its direction from a to b); of the chord a → b where p is one of
/// the two.
template <class V>
V circleTangent(V a, V p, V b) {
  const V before = p - a, after = b - p;
  const double n = dot(before, before), m = dot(after, after);
  if (n == 0 || m == 0) return normalized(b - a);
  return normalized(before / n + after / m);
}

/// Handle of a cubic arc over `chord` that leaves at the unit `tangent`: a third of the chord when
/// straight, and such that equal angles at both ends give a circle's arc.
template <class V>
V circleHandle(V chord, V tangent) {
  constexpr double kSharpest = -0.5;  // beyond 120° from the chord the handle would run away
  const double length = norm(chord);
  if (length == 0) return {};
  const double cosine = std::max(kSharpest, dot(chord, tangent) / length);
  return tangent * (length / (1.5 * (1 + cosine)));  // 1/(3 cos²(α/2)), α between the two
}

}  // namespace spineloft::geometry
