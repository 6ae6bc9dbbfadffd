// Where lines that were drawn in space lie on a surface. Internal to pull/.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/vec.h"
#include "engine/pull/cut_mesh.h"

namespace spineloft::pull {

/// A place on the surface. Unit: the normal of its triangle, and of what is around it (who needs that fills it in).
struct Place {
  ModelPoint at, face, normal;
  std::uint32_t triangle = 0;
};

/// Finds places of a mesh, as it is when this is made.
class Places {
 public:
  explicit Places(const CutMesh& mesh);

  /// None: no triangle has an area. Cost: that of the triangles.
  std::optional<Place> nearest(ModelPoint p) const;
  /// The mean of the normals of all triangles that come as near to a place as `reach`: on an edge that of both sides.
  ModelPoint meanNormal(ModelPoint at, double reach) const;
  /// The nearest place of each point, but for those that lie where the one before does.
  std::vector<Place> lay(std::span<const ModelPoint> points, double apart) const;

 private:
  const CutMesh& mesh_;
  std::vector<ModelPoint> centres_;  // of the triangles
  std::vector<double> sizes_;        // how far their corners are from there
};

}  // namespace spineloft::pull
