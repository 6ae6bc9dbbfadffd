#include "engine/stack/stack_params.h"

#include <algorithm>
#include <cmath>

namespace spineloft::stack {
namespace {

bool isNear(double value) { return std::abs(value) <= kFarOut; }  // false for what is not finite
bool isNear(const ModelPoint& p) { return isNear(p.x) && isNear(p.y) && isNear(p.z); }

bool isInRange(const Pattern& p) { return p.times >= 1 && p.times <= kMostTimes && p.spacing >= 0 && p.spacing <= 1; }
bool isInRange(const Rough& r) {
  return r.amount >= 0 && r.amount <= kMostRough && r.size >= kLeastBump && r.size <= kFarOut;
}

}  // namespace

bool isValid(const Curve& curve) {
  const std::size_t count = curve.through.size();
  return count >= (curve.open ? 2 : 3) && count <= kMostThrough && curve.as < CurveUse::kCount && curve.width >= 0 &&
         isNear(curve.width) && isNear(curve.base) &&
         std::ranges::all_of(
             curve.through, [](SectionPoint p) { return isNear(p.x) && isNear(p.y); }) &&
         std::ranges::all_of(curve.corners.at, [&](std::uint32_t i) { return i < count; });
}

bool isValid(const StackParams& p) {
  return p.startCap < sections::CapStyle::kCount && p.endCap < sections::CapStyle::kCount && p.sides >= kLeastSides &&
         p.sides <= kMostSides && p.capRings >= 1 && p.capRings <= kMostCapRings &&
         p.patterns.size() <= kMostPatterns &&
         std::ranges::all_of(p.patterns, [](const Pattern& one) { return isInRange(one); }) && isInRange(p.rough);
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

Status checkPlanes(const std::vector<Plane>& planes, const Rail& rail, const std::vector<Pattern>& patterns) {
  if (planes.size() > kMostPlanes) return {Error::ValueOutOfRange, "more than 64 sheets"};
  if (!isValid(rail)) return {Error::ValueOutOfRange, "rail"};
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const std::string name = "sheet " + std::to_string(i + 1);
    for (std::size_t c = 0; c < planes[i].curves.size(); ++c) {
      if (!isValid(planes[i].curves[c])) {
        return {Error::ValueOutOfRange, "curve " + std::to_string(c + 1) + " on " + name};
      }
    }
    if (!isValid(planes[i])) return {Error::ValueOutOfRange, name};
  }
  std::size_t points = 0;
  for (const Plane& plane : planes) {
    for (const Curve& curve : plane.curves) points += curve.through.size();
  }
  if (points > kMostPoints) return {Error::ValueOutOfRange, "more than 50,000 points"};
  if (std::ranges::all_of(planes, [](const Plane& plane) { return plane.curves.empty(); })) {
    return {Error::StackInvalid, "there is no curve on a sheet yet: draw one"};
  }
  return checkPatterns(planes, patterns);
}

}  // namespace spineloft::stack
