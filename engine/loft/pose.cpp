#include "engine/loft/pose.h"

#include <algorithm>
#include <cmath>

namespace spineloft::loft {

bool isValid(const Pose& pose) {
  return pose.stroke.size() != 1 && pose.stroke.size() <= kMostStrokePoints &&
         std::ranges::all_of(pose.stroke, [](PicturePoint p) { return isFinite(p); }) &&
         geometry::isValid(pose.depth, -kMostDepth, kMostDepth) && std::abs(pose.coilTurns) <= kMostCoilTurns &&
         pose.coilRadius >= 0 && pose.coilRadius <= kMostCoilRadius;
}

}  // namespace spineloft::loft
