// Where a ray meets a mesh.
#pragma once

#include <cstddef>
#include <limits>

#include "engine/base/vec.h"
#include "engine/mesh/tri_mesh.h"

namespace spineloft::mesh {

struct RayHit {
  double far = std::numeric_limits<double>::infinity();  ///< a multiple of the direction; infinite: it meets nothing
  std::size_t triangle = 0;
};
/// Where a ray in ModelSpace meets one of the triangles `first` … `last` − 1 of a mesh first, from either side (Möller
/// and Trumbore 1997).
RayHit firstHit(const TriMesh& mesh, ModelPoint eye, ModelPoint direction, std::size_t first, std::size_t last);
/// The same of all its triangles.
inline RayHit firstHit(const TriMesh& mesh, ModelPoint eye, ModelPoint direction) {
  return firstHit(mesh, eye, direction, 0, mesh.triangles.size());
}

}  // namespace spineloft::mesh
