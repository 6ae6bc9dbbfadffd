// Sections on a line that bends tighter than they are wide.
#pragma once

#include <cmath>

#include "engine/base/vec.h"

namespace spineloft::geometry {

/// How far a point that is `off` its line is held back, so that what would reach beyond the centre of the line's bend
/// does not fold. `bend`: towards that centre, 1 over the radius, not 0.
inline ModelPoint heldBack(ModelPoint off, ModelPoint bend) {
  constexpr double kFree = 0.7, kMost = 0.95;  // 1 is the centre of the bend
  const double reach = dot(off, bend);
  if (reach <= kFree) return {};
  const double held = kFree + (kMost - kFree) * (1 - std::exp(-(reach - kFree) / (kMost - kFree)));
  return bend * ((held - reach) / dot(bend, bend));
}

}  // namespace spineloft::geometry
