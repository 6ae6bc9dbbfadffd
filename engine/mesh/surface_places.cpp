#include "engine/mesh/surface_places.h"

#include <algorithm>
#include <array>
#include <limits>

#include "engine/geometry/polyline.h"

namespace spineloft::mesh {
namespace {

std::array<ModelPoint, 3> cornersOf(const TriMesh& mesh, std::uint32_t triangle) {
  const auto& t = mesh.triangles[triangle];
  return {modelPoint(mesh, t[0]), modelPoint(mesh, t[1]), modelPoint(mesh, t[2])};
}

}  // namespace

ModelPoint areaNormal(const TriMesh& mesh, std::uint32_t triangle) {
  const auto [a, b, c] = cornersOf(mesh, triangle);
  return cross(b - a, c - a);
}

ModelPoint nearestOn(const TriMesh& mesh, std::uint32_t triangle, ModelPoint p) {
  const std::array<ModelPoint, 3> corners = cornersOf(mesh, triangle);
  const ModelPoint normal = areaNormal(mesh, triangle);
  const double area2 = dot(normal, normal);
  bool inside = area2 > 0;
  for (std::size_t i = 0; i < 3 && inside; ++i) {
    inside = dot(cross(corners[(i + 1) % 3] - corners[i], p - corners[i]), normal) >= 0;
  }
  if (inside) return p - normal * (dot(p - corners[0], normal) / area2);
  ModelPoint best = corners[0];
  for (std::size_t i = 0; i < 3; ++i) {
    const ModelPoint on = geometry::nearestOnSegment(p, corners[i], corners[(i + 1) % 3]);
    if (distance(on, p) < distance(best, p)) best = on;
  }
  return best;
}

SurfacePlaces::SurfacePlaces(const TriMesh& mesh) : mesh_(mesh) {
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = cornersOf(mesh, t);
    const ModelPoint centre = (a + b + c) / 3;
    centres_.push_back(centre);
    sizes_.push_back(std::max({distance(a, centre), distance(b, centre), distance(c, centre)}));
  }
}

std::optional<SurfacePlace> SurfacePlaces::nearest(ModelPoint p, const std::optional<SurfacePlace>& near) const {
  std::optional<SurfacePlace> best;
  double least = std::numeric_limits<double>::infinity();
  const auto take = [&](std::uint32_t triangle) {
    const ModelPoint on = nearestOn(mesh_, triangle, p), normal = areaNormal(mesh_, triangle);
    if (distance(on, p) >= least || dot(normal, normal) <= 0) return;
    least = distance(on, p);
    best = {on, normalized(normal), {}, triangle};
  };
  if (near) take(near->triangle);
  for (std::uint32_t t = 0; t < centres_.size(); ++t) {
    const ModelPoint away = centres_[t] - p;
    const double reach = least + sizes_[t];
    if (dot(away, away) < reach * reach) take(t);
  }
  return best;
}

ModelPoint SurfacePlaces::meanNormal(ModelPoint at, double reach) const {
  ModelPoint sum;
  for (std::uint32_t t = 0; t < centres_.size(); ++t) {
    const ModelPoint away = centres_[t] - at;
    const double farthest = reach + sizes_[t];
    if (dot(away, away) > farthest * farthest || distance(nearestOn(mesh_, t, at), at) > reach) continue;
    const ModelPoint normal = areaNormal(mesh_, t);
    if (dot(normal, normal) > 0) sum += normalized(normal);
  }
  return normalized(sum);
}

std::vector<SurfacePlace> SurfacePlaces::lay(std::span<const ModelPoint> points, double apart) const {
  std::vector<SurfacePlace> line;
  for (const ModelPoint p : points) {
    const auto place = nearest(p);
    if (place && (line.empty() || distance(line.back().at, place->at) > apart)) line.push_back(*place);
  }
  return line;
}

}  // namespace spineloft::mesh
