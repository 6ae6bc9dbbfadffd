#include "engine/descriptive/solids.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/descriptive/square.h"
#include "engine/geometry/triangulate.h"
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

/// Its faces as they are, the whole moved by `depth` along z; pixels.
mesh::TriMesh facedMesh(const FacedSolid& solid, double depth, const DepthScale& scale, image::Size board) {
  mesh::TriMesh out;
  for (const ModelPoint& corner : solid.corners) {
    const double x = scale.middle.x + corner.x * scale.size, y = scale.middle.y - corner.y * scale.size;
    out.positions.push_back(
        {static_cast<float>(x), static_cast<float>(-y), static_cast<float>((corner.z + depth) * scale.size)});
    out.uv.push_back(mesh::frontUv(x, -y, {static_cast<double>(board.width), static_cast<double>(board.height)}));
  }
  for (const Wireframe::Face& face : solid.faces) {
    // In the face's own plane, so that it is counter-clockwise there.
    const ModelPoint normal = normalOf(solid, face);
    const ModelPoint right =
        normalized(cross(std::abs(normal.y) < 0.9 ? ModelPoint{0, 1, 0} : ModelPoint{1, 0, 0}, normal));
    const ModelPoint up = cross(normal, right);
    std::vector<SectionPoint> flat;
    for (const std::uint32_t corner : face) {
      flat.push_back({dot(solid.corners[corner], right), dot(solid.corners[corner], up)});
    }
    for (const auto& [a, b, c] : geometry::triangulate(std::span<const SectionPoint>(flat))) {
      out.triangles.push_back({face[a], face[b], face[c]});
    }
  }
  return out;
}

}  // namespace

mesh::TriMesh solidOf(const Patch& patch, const Piece& piece, const PieceDepth& depth, const DepthScale& scale,
                      image::Size board) {
  if (const FacedSolid* faced = patch.faced()) {
    const double moved = depth.middle[0] - patch.riseAt({{0, 0, 0}, {1, 0, 0}});
    return facedMesh(*faced, moved, scale, board);
  }
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
