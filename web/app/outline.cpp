#include "web/app/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/geometry/polygon.h"
#include "engine/publish/publish.h"

namespace spineloft::app {
namespace {

double distanceToSegment(PicturePoint p, PicturePoint a, PicturePoint b) {
  const PicturePoint along = b - a;
  const double length2 = dot(along, along);
  const double t = length2 > 0 ? std::clamp(dot(p - a, along) / length2, 0.0, 1.0) : 0.0;
  return distance(p, a + along * t);
}

bool nearSpine(const pipeline::PartShape& shape, PicturePoint p, double reach) {
  const auto& points = shape.spine.points;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (distanceToSegment(p, points[i - 1], points[i]) <= reach) return true;
  }
  return false;
}

/// Where a ray in ModelSpace meets the mesh first, as a multiple of its direction (Möller and
/// Trumbore 1997).
double firstHit(const mesh::TriMesh& mesh, ModelPoint eye, ModelPoint direction) {
  double nearest = std::numeric_limits<double>::infinity();
  const auto corner = [&](std::uint32_t i) {
    const auto& p = mesh.positions[i];
    return ModelPoint{p[0], p[1], p[2]};
  };
  for (const auto& triangle : mesh.triangles) {
    const ModelPoint a = corner(triangle[0]);
    const ModelPoint ab = corner(triangle[1]) - a, ac = corner(triangle[2]) - a;
    const ModelPoint h = cross(direction, ac);
    const double det = dot(ab, h);
    if (det == 0) continue;
    const ModelPoint s = eye - a;
    const double u = dot(s, h) / det;
    if (u < 0 || u > 1) continue;
    const ModelPoint q = cross(s, ab);
    const double v = dot(direction, q) / det;
    if (v < 0 || u + v > 1) continue;
    const double t = dot(ac, q) / det;
    if (t > 0 && t < nearest) nearest = t;
  }
  return nearest;
}

}  // namespace

void outlineOf(const pipeline::PartShape& shape, const loft::LoftParams& params,
               std::vector<PicturePoint>& out) {
  out.clear();
  const auto& ribs = shape.ribs.ribs;
  for (const ribs::Rib& rib : ribs) out.push_back(rib.left);
  if (params.endCap == loft::CapStyle::Round) {
    const auto& fan = shape.ribs.endFan.points;
    out.insert(out.end(), fan.begin(), fan.end());
  }
  for (auto rib = ribs.rbegin(); rib != ribs.rend(); ++rib) out.push_back(rib->right);
  if (params.startCap == loft::CapStyle::Round) {
    const auto& fan = shape.ribs.startFan.points;
    out.insert(out.end(), fan.rbegin(), fan.rend());
  }
}

PartId partAt(const document::Document& document, const pipeline::Derived& derived,
              PictureId picture, PicturePoint p, double reach) {
  std::vector<PicturePoint> outline;
  const std::size_t count = std::min(document.parts.size(), derived.parts.size());
  for (std::size_t i = count; i-- > 0;) {
    const document::Part& part = document.parts[i];
    const auto& shape = derived.parts[i].shape;
    if (!shape || !part.visible || part.recipe.picture != picture) continue;
    outlineOf(*shape, part.recipe.loft, outline);
    if (geometry::holds(std::span<const PicturePoint>(outline), p) || nearSpine(*shape, p, reach)) return part.id;
  }
  return {};
}

PartId partUnderRay(const document::Document& document, const pipeline::Derived& derived,
                    const Ray& ray) {
  PartId best;
  double nearest = std::numeric_limits<double>::infinity();
  const std::size_t count = std::min(document.parts.size(), derived.parts.size());
  for (std::size_t i = 0; i < count; ++i) {
    const document::Part& part = document.parts[i];
    const auto& shape = derived.parts[i].shape;
    const document::PictureEntry* entry = document::findPicture(document, part.recipe.picture);
    if (!shape || !part.visible || entry == nullptr) continue;
    const publish::WorldFrame frame =
        publish::worldFrame(entry->size);
    const double s = 1 / frame.scale;
    const ModelPoint eye{ray.eye.x * s + frame.centre.x, ray.eye.y * s + frame.centre.y,
                         ray.eye.z * s + frame.centre.z};
    const ModelPoint direction{ray.direction.x * s, ray.direction.y * s, ray.direction.z * s};
    const double hit = firstHit(shape->mesh, eye, direction);
    if (hit < nearest) {
      nearest = hit;
      best = part.id;
    }
  }
  return best;
}

}  // namespace spineloft::app
