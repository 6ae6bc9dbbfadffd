#include "engine/mesh/ray_hit.h"

namespace spineloft::mesh {

RayHit firstHit(const TriMesh& mesh, ModelPoint eye, ModelPoint direction, std::size_t first, std::size_t last) {
  RayHit nearest;
  const auto corner = [&](std::uint32_t vertex) {
    const auto& p = mesh.positions[vertex];
    return ModelPoint{p[0], p[1], p[2]};
  };
  for (std::size_t i = first; i < last; ++i) {
    const auto& triangle = mesh.triangles[i];
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
    if (t > 0 && t < nearest.far) nearest = {t, i};
  }
  return nearest;
}

}  // namespace spineloft::mesh
