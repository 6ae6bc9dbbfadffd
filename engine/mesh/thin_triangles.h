// Thin triangles of a mesh, taken away where its surface stays as it is.
#pragma once

#include "engine/mesh/tri_mesh.h"

namespace spineloft::mesh {

struct ThinLimits {
  double angle = 0.27;  ///< radians: a triangle with a smaller one is thin
  double bend = 0.2;    ///< radians that a triangle may turn by
  double off = 0;       ///< how far a point may come to lie off the surface, units of the mesh
};

/// Of every thin triangle of a closed 2-manifold its longest edge is flipped, if the smallest angle grows by that, or
/// its shortest edge becomes one of its ends, if fewer triangles round it are thin then; where no limit is passed. The
/// mesh stays closed, 2-manifold and of the same genus; creases stay. Points that are no longer used go; the others
/// keep their order, place and UV. Same input, same result. Cost: linear.
void removeThinTriangles(TriMesh& mesh, const ThinLimits& limits);

}  // namespace spineloft::mesh
