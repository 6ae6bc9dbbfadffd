#include "engine/stack/stack_params.h"

#include <algorithm>
#include <cmath>

namespace spineloft::stack {
namespace {

bool isNear(double value) { return std::abs(value) <= kFarOut; }  // false for what is not finite
bool isNear(const ModelPoint& p) { return isNear(p.x) && isNear(p.y) && isNear(p.z); }

bool isInRange(const Pattern& p) { return p.times >= 1 && p.times <= kMostTimes && p.spacing >= 0 && p.spacing <= 1; }
bool isShare(std::optional<double> v) { return !v || (*v >= 0 && *v <= 1); }
bool isInRange(const Rough& r) {
  return r.amount >= 0 && r.amount <= kMostRough && r.size >= kLeastBump && r.size <= kFarOut;
}

}  // namespace

bool isValid(const Curve& curve) {
  const std::size_t count = curve.through.size();
  return count >= (curve.open ? 2 : 3) && count <= kMostThrough && curve.as < CurveUse::kCount && curve.width >= 0 &&
         isNear(curve.width) && isNear(curve.base) && isShare(curve.forkAt) && isShare(curve.joinAt) &&
         std::ranges::all_of(
             curve.through, [](SectionPoint p) { return isNear(p.x) && isNear(p.y); }) &&
         std::ranges::all_of(curve.corners.at, [&](std::uint32_t i) { return i < count; });
}

bool isValid(const StackParams& p) {
  return p.startCap < sections::CapStyle::kCount && p.endCap < sections::CapStyle::kCount && p.sides >= kLeastSides &&
         p.sides <= kMostSides && p.capRings >= 1 && p.capRings <= kMostCapRings &&
         p.patterns.size() <= kMostPatterns &&
         std::ranges::all_of(
             p.patterns, [](const Pattern& one) { return isInRange(one); }) &&
         isInRange(p.rough) && p.melt >= 0 && p.melt <= 1;
}

bool isValid(const Rail& rail) {
  const std::size_t count = rail.points.size();
  return count <= kMostRailPoints && std::ranges::all_of(rail.points, [](const ModelPoint& p) { return isNear(p); });
}

bool isValid(const Plane& plane) {
  return plane.at >= 0 && plane.at <= 1 && (!plane.origin || isNear(*plane.origin)) && geometry::isValid(plane.turn) &&
         sections::isValid(plane.blend) && plane.curves.size() <= kMostCurves && plane.links.size() <= kMostLinks &&
         std::ranges::all_of(plane.curves, [](const Curve& curve) { return isValid(curve); });
}

std::optional<std::size_t> nextDrawn(const std::vector<Plane>& planes, bool closed, std::size_t plane) {
  for (std::size_t step = 1; step <= planes.size(); ++step) {
    const std::size_t next = plane + step;
    if (next >= planes.size() && !closed) return std::nullopt;
    if (!planes[next % planes.size()].curves.empty()) return next % planes.size();
  }
  return std::nullopt;
}

Status checkLinks(const std::vector<Plane>& planes, bool closed, std::size_t i) {
  const std::vector<CurveLink>& links = planes[i].links;
  if (links.empty()) return Done{};
  const std::optional<std::size_t> next = nextDrawn(planes, closed, i);
  const auto refused = [&](std::string why) {
    return Failure{Error::StackInvalid, "sheet " + std::to_string(i + 1) + " " + std::move(why)};
  };
  if (!next) return refused("has links, and no sheet follows it: take them out");
  for (auto link = links.begin(); link != links.end(); ++link) {
    if (link->from >= planes[i].curves.size() || link->to >= planes[*next].curves.size()) {
      return refused("links curve " + std::to_string(link->from + 1) + " with curve " + std::to_string(link->to + 1) +
                     " of the next: there is no such curve");
    }
    const auto same = [&](const CurveLink& other) { return other.from == link->from && other.to == link->to; };
    if (std::any_of(links.begin(), link, same)) {
      return refused("says twice whether curve " + std::to_string(link->from + 1) + " becomes curve " +
                     std::to_string(link->to + 1) + ": say it once");
    }
  }
  return Done{};
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
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (Status links = checkLinks(planes, rail.closed, i); !links) return links;
  }
  return checkPatterns(planes, patterns);
}

}  // namespace spineloft::stack
