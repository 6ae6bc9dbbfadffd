#include "engine/stack/stand.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "engine/stack/outline.h"
#include "engine/stack/rail_line.h"
#include "engine/stack/sheets.h"

namespace spineloft::stack {

Stand standOf(const Plane& plane, const std::optional<RailLine>& rail) {
  Stand stand{{}, {1, 0, 0}, {0, 1, 0}};
  if (plane.origin) {
    stand.origin = *plane.origin;
    stand.x = geometry::turned(plane.turn, stand.x);
    stand.y = geometry::turned(plane.turn, stand.y);
    return stand;
  }
  const geometry::Frame frame = rail->at(plane.at);
  const auto inFrame = [&](ModelPoint v) {
    return frame.across * v.x + frame.depth * v.y + cross(frame.across, frame.depth) * v.z;
  };
  stand.origin = frame.at;
  stand.x = inFrame(geometry::turned(plane.turn, stand.x));
  stand.y = inFrame(geometry::turned(plane.turn, stand.y));
  return stand;
}

Result<Stand> standOf(const Plane& plane, const Rail& rail) {
  if (plane.origin) return standOf(plane, std::optional<RailLine>());
  const Result<RailLine> line = RailLine::of(rail);
  if (!line) return line.failure();
  return standOf(plane, std::optional(line.value()));
}

geometry::Turn turnBetween(const Stand& from, const Stand& to) {
  const auto in = [&](ModelPoint v) { return ModelPoint{dot(v, from.x), dot(v, from.y), dot(v, from.normal())}; };
  const ModelPoint normal = in(to.normal()), x = in(to.x);
  const geometry::Turn lean = geometry::turnTo(ModelPoint{0, 0, 1}, normal);
  const ModelPoint leant = geometry::turned(lean, ModelPoint{1, 0, 0});
  const double angle = std::atan2(dot(cross(leant, x), normal), dot(leant, x));
  return geometry::after(lean, geometry::turnAbout(normal, angle));
}

Result<std::vector<Stand>> standsOf(const std::vector<Plane>& planes, const Rail& rail) {
  std::optional<RailLine> line;
  if (std::ranges::any_of(planes, [](const Plane& plane) { return !plane.origin; })) {
    Result<RailLine> made = RailLine::of(rail);
    if (!made) return made.failure();
    line = std::move(made).value();
  }
  std::vector<Stand> stands;
  for (const Plane& plane : planes) stands.push_back(standOf(plane, line));
  return stands;
}

double lengthOf(const Rail& rail) {
  const Result<RailLine> line = RailLine::of(rail);
  return line ? line.value().length() : 0;
}

Curve curveThrough(const sections::DrawnCurve& drawn) {
  Curve curve;
  curve.corners.all = std::ranges::all_of(drawn.points, &sections::DrawnPoint::corner);
  for (const sections::DrawnPoint& point : drawn.points) {
    if (point.corner && !curve.corners.all) {
      curve.corners.at.push_back(static_cast<std::uint32_t>(curve.through.size()));
    }
    curve.through.push_back(point.at);
  }
  return curve;
}

std::vector<SectionPoint> outlineOf(const Curve& curve) { return polygonOf(curve).points; }

}  // namespace spineloft::stack
