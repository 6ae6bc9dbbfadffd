#include "engine/stack/stack_params.h"

#include <algorithm>
#include <cmath>

namespace spineloft::stack {
namespace {

bool isNear(double value) { return std::abs(value) <= kFarOut; }  // false for what is not finite
bool isNear(const ModelPoint& p) { return isNear(p.x) && isNear(p.y) && isNear(p.z); }

}  // namespace

bool isValid(const Curve& curve) {
  const std::size_t count = curve.through.size();
  return count >= 3 && count <= kMostThrough &&
         std::ranges::all_of(curve.through, [](SectionPoint p) { return isNear(p.x) && isNear(p.y); }) &&
         std::ranges::all_of(curve.corners.at, [&](std::uint32_t i) { return i < count; });
}

bool isValid(const StackParams& p) {
  return p.startCap < sections::CapStyle::kCount && p.endCap < sections::CapStyle::kCount && p.sides >= kLeastSides &&
         p.sides <= kMostSides && p.capRings >= 1 && p.capRings <= kMostCapRings;
}

bool isValid(const Rail& rail) {
  const std::size_t count = rail.points.size();
  return count <= kMostRailPoints && std::ranges::all_of(rail.points, [](const ModelPoint& p) { return isNear(p); });
}

bool isValid(const Plane& plane) {
  return plane.at >= 0 && plane.at <= 1 && (!plane.origin || isNear(*plane.origin)) && geometry::isValid(plane.turn) &&
         sections::isValid(plane.blend) && plane.curves.size() <= kMostCurves &&
         std::ranges::all_of(plane.curves, [](const Curve& curve) { return isValid(curve); });
}

Status checkPlanes(const std::vector<Plane>& planes, const Rail& rail) {
  if (planes.size() > kMostPlanes) return {Error::ValueOutOfRange, "more than 64 sheets"};
  if (!isValid(rail)) return {Error::ValueOutOfRange, "rail"};
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (!isValid(planes[i])) return {Error::ValueOutOfRange, "sheet " + std::to_string(i + 1)};
  }
  std::size_t points = 0;
  for (const Plane& plane : planes) {
    for (const Curve& curve : plane.curves) points += curve.through.size();
  }
  if (points > kMostPoints) return {Error::ValueOutOfRange, "more than 50,000 points"};
  if (std::ranges::all_of(planes, [](const Plane& plane) { return plane.curves.empty(); })) {
    return {Error::StackInvalid, "there is no curve on a sheet yet: draw one"};
  }
  return Done{};
}

}  // namespace spineloft::stack
