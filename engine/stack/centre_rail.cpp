#include "engine/stack/centre_rail.h"

#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "engine/base/limits.h"
#include "engine/geometry/polygon.h"
#include "engine/stack/outline.h"
#include "engine/stack/rail_line.h"
#include "engine/stack/sheets.h"

namespace spineloft::stack {

std::optional<SectionPoint> centreOf(const Plane& plane) {
  SectionPoint sum;
  double whole = 0;
  for (const Curve& curve : plane.curves) {
    const std::vector<SectionPoint> outline = polygonOf(curve).points;
    const double area = std::abs(geometry::signedArea(std::span<const SectionPoint>(outline)));
    sum = sum + geometry::centroid(std::span<const SectionPoint>(outline)) * area;
    whole += area;
  }
  return whole > 0 ? std::optional(sum / whole) : std::nullopt;
}

void moveCurves(Plane& plane, SectionPoint by) {
  for (Curve& curve : plane.curves) {
    for (SectionPoint& p : curve.through) p = p + by;
    curve.base += curve.as == CurveUse::Ground ? by.y : 0;
  }
}

Result<OnRail> ontoCentres(const std::vector<Plane>& planes, const Rail& rail) {
  if (planes.size() < (rail.closed ? 3u : 2u)) {
    return {Error::StackInvalid, rail.closed ? "a closed rail through the middles needs three sheets: draw another one"
                                             : "a rail through the middles needs two sheets: draw another one"};
  }
  auto stood = standsOf(planes, rail);
  if (!stood) return stood.failure();
  std::vector<Stand> stands = std::move(stood).value();
  OnRail out{planes, {{}, rail.closed}};
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const std::string name = "sheet " + std::to_string(i + 1);
    const auto centre = centreOf(planes[i]);
    if (!centre) return {Error::StackInvalid, name + " has no curve: draw one, or remove it"};
    const ModelPoint at = stands[i].origin = stands[i].at(*centre);
    const bool twice = (i > 0 && distance(at, out.rail.points.back()) <= kSamePoint) ||
                       (rail.closed && i + 1 == planes.size() && distance(at, out.rail.points.front()) <= kSamePoint);
    if (twice) return {Error::StackInvalid, name + " has its middle where its neighbour has: move one of them"};
    out.rail.points.push_back(at);
    moveCurves(out.planes[i], *centre * -1);
  }
  const auto along = RailLine::of(out.rail);
  if (!along) return along.failure();
  for (std::size_t i = 0; i < planes.size(); ++i) {
    Plane& plane = out.planes[i];
    plane.origin.reset();
    plane.turn = {};
    plane.at = along.value().shareOf(i);
    plane.turn = turnBetween(standOf(plane, std::optional(along.value())), stands[i]);
  }
  return out;
}

}  // namespace spineloft::stack
