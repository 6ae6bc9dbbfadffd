#include "web/edit/fly_along.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "engine/geometry/frames.h"
#include "engine/geometry/polyline.h"
#include "engine/stack/stand.h"
#include "web/edit/placing.h"
#include "web/edit/section_editing.h"

namespace spineloft::app {
namespace {

constexpr double kBehind = 0.55, kBeside = 0.85;  // of the way from a place to the eye: along the line, and across
constexpr double kSeen = 2.2;                     // half the height that is seen there, times the part's thickness
constexpr double kLeastFlat = 1e-3;

/// A place of the line, which way it goes on, and the side that faces the viewer.
struct Way {
  ModelPoint at, tangent, front;
};

std::vector<Way> wayAlong(const document::StackRecipe& layers) {
  std::vector<stack::Plane> planes(kAlongWay);
  for (std::size_t i = 0; i < planes.size(); ++i) planes[i].at = static_cast<double>(i) / (kAlongWay - 1);
  const auto stands = stack::standsOf(planes, layers.rail);
  std::vector<Way> out;
  if (!stands) return out;
  for (const stack::Stand& stand : stands.value()) {
    out.push_back({stand.origin, cross(stand.y, stand.x), stand.y});
  }
  // Of a closed line the last place is the first one.
  if (layers.rail.closed) out.back() = out.front();
  return out;
}

std::vector<Way> wayAlong(const std::vector<ModelPoint>& centreLine, bool closed) {
  if (centreLine.size() < 2) return {};
  const auto line = geometry::resample(std::span<const ModelPoint>(centreLine), kAlongWay);
  std::vector<ModelPoint> tangents;
  geometry::tangentsOf(line, closed, tangents);
  std::vector<Way> out;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const ModelPoint viewer{0, 0, 1};
    ModelPoint front = viewer - tangents[i] * dot(viewer, tangents[i]);
    if (norm(front) < kLeastFlat) front = out.empty() ? ModelPoint{0, 1, 0} : out.back().front;
    out.push_back({line[i], tangents[i], normalized(front)});
  }
  return out;
}

std::vector<Way> wayOf(const document::Part& part, const pipeline::PartShape& shape) {
  if (const auto* layers = document::stackOf(part)) return wayAlong(*layers);
  const auto* loft = document::loftOf(part);
  return loft ? wayAlong(shape.centreLine, loft->pose.closed) : std::vector<Way>();
}

/// How far the surface is from the line, at most but for a tenth of its points, model units.
double thicknessAbout(const std::vector<Way>& way, const mesh::TriMesh& mesh) {
  std::vector<double> away;
  for (const auto& p : mesh.positions) {
    const ModelPoint q{p[0], p[1], p[2]};
    double least = distance(q, way.front().at);
    for (const Way& place : way) least = std::min(least, distance(q, place.at));
    away.push_back(least);
  }
  if (away.empty()) return 0;
  const auto most = away.begin() + static_cast<std::ptrdiff_t>(away.size() * 9 / 10);
  std::ranges::nth_element(away, most);
  return *most;
}

}  // namespace

std::vector<Camera> camerasAlong(const document::Document& document, const pipeline::Derived& derived,
                                 const UiState& ui, PartId id) {
  const document::Part* part = document::findPart(document, id);
  const pipeline::PartShape* shape = part ? shapeOf(document, derived, id) : nullptr;
  const auto* entry = shape ? document::findPicture(document, document::pictureOf(*part)) : nullptr;
  if (entry == nullptr) return {};
  const std::vector<Way> way = wayOf(*part, *shape);
  if (way.empty()) return {};
  const pipeline::ToWorld toWorld = *shownCopies(ui, *part, entry->size).begin();
  const double thick = thicknessAbout(way, smoothMesh(*shape)) * toWorld.scale;
  std::vector<Camera> out;
  for (const Way& place : way) {
    const WorldPoint back = normalized(toWorld.along(place.front * kBeside - place.tangent * kBehind));
    Camera camera = out.empty() ? ui.camera : out.back();
    camera.target = toWorld(place.at);
    camera.pitch = std::clamp(std::asin(std::clamp(back.y, -1.0, 1.0)), -kMaxPitch, kMaxPitch);
    if (std::hypot(back.x, back.z) > kLeastFlat) camera.yaw = std::atan2(back.x, back.z);
    camera.distance = std::clamp(kSeen * thick / kHalfHeight, kMinDistance, kMaxDistance);
    out.push_back(camera);
  }
  return out;
}

}  // namespace spineloft::app
