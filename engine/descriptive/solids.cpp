#include "engine/descriptive/solids.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/mesh/two_sided.h"

namespace spineloft::descriptive {
namespace {

/// The normal of the plane on which a flat piece lies, z > 0.
ModelPoint normalOf(const Patch& patch, std::span<const double> z) {
  // The triangle with the largest area in the picture says it best.
  ModelPoint best{0, 0, 1};
  double most = 0;
  const auto& points = patch.mesh().points();
  for (const auto& [a, b, c] : patch.mesh().triangles()) {
    const ModelPoint pa{points[a].x, points[a].y, z[a]}, pb{points[b].x, points[b].y, z[b]},
        pc{points[c].x, points[c].y, z[c]};
    const ModelPoint normal = cross(pb - pa, pc - pa);
    if (normal.z <= most) continue;
    most = normal.z;
    best = normal;
  }
  return normalized(best);
}

}  // namespace

mesh::TriMesh solidOf(const Patch& patch, const Piece& piece, const PieceDepth& depth, const DepthScale& scale,
                      image::Size board) {
  std::vector<double> front(depth.middle.size()), back(depth.middle.size());
  for (std::size_t i = 0; i < front.size(); ++i) {
    front[i] = (depth.middle[i] + depth.front[i]) * scale.size;
    back[i] = (depth.middle[i] - depth.back[i]) * scale.size;
  }
  const mesh::PictureSize size{static_cast<double>(board.width), static_cast<double>(board.height)};
  mesh::TriMesh solid = mesh::solidBetween({patch.mesh(), front}, {patch.mesh(), back}, patch.rims(), size);
  if (piece.kind != PieceKind::Flat) return solid;
  // Both sides move along the plane, so that what stands between them is its normal.
  const ModelPoint normal = normalOf(patch, front);
  const std::size_t n = front.size();
  for (std::size_t i = 0; i < solid.positions.size(); ++i) {
    const std::size_t point = i % n;
    const double sign = i < n ? 1 : -1;
    const double along = (front[point] - back[point]) / 2 * normal.z;
    const double middle = (front[point] + back[point]) / 2;
    const SectionPoint p = patch.mesh().points()[point];
    solid.positions[i] = {static_cast<float>(p.x + sign * along * normal.x),
                          static_cast<float>(p.y + sign * along * normal.y),
                          static_cast<float>(middle + sign * along * normal.z)};
  }
  return solid;
}

}  // namespace spineloft::descriptive
