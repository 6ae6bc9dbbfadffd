// The places of a surface that are nearest to points in space.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/vec.h"
#include "engine/mesh/tri_mesh.h"

namespace spineloft::mesh {

/// A corner of the mesh, in ModelSpace.
inline ModelPoint modelPoint(const TriMesh& mesh, std::uint32_t vertex) {
  const std::array<float, 3>& p = mesh.positions[vertex];
  return {p[0], p[1], p[2]};
}
/// Twice the area of a triangle, along its normal.
ModelPoint areaNormal(const TriMesh& mesh, std::uint32_t triangle);
/// The place of a triangle that is nearest to p.
ModelPoint nearestOn(const TriMesh& mesh, std::uint32_t triangle, ModelPoint p);

/// A place on the surface. Unit: the normal of its triangle, and of what is around it (who needs that fills it in).
struct SurfacePlace {
  ModelPoint at, face, normal;
  std::uint32_t triangle = 0;
};

/// Finds places of a mesh (ModelSpace), as it is when this is made; the mesh outlives it.
class SurfacePlaces {
 public:
  explicit SurfacePlaces(const TriMesh& mesh);

  /// None: no triangle has an area. Cost: that of the triangles; less with a place near to the wanted one.
  std::optional<SurfacePlace> nearest(ModelPoint p, const std::optional<SurfacePlace>& near = {}) const;
  /// The mean of the normals of all triangles that come as near to a place as `reach`: on an edge that of both sides.
  ModelPoint meanNormal(ModelPoint at, double reach) const;
  /// The nearest place of each point, but for those that lie where the one before does.
  std::vector<SurfacePlace> lay(std::span<const ModelPoint> points, double apart) const;

 private:
  const TriMesh& mesh_;
  std::vector<ModelPoint> centres_;  // of the triangles
  std::vector<double> sizes_;        // how far their corners are from there
};

}  // namespace spineloft::mesh
