// Pulls: a line on the surface of a part is moved, and what is near follows (method-pull.md).
#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/vec.h"
#include "engine/mesh/tri_mesh.h"
#include "engine/pull/pull_params.h"

namespace spineloft::pull {

/// A mesh with a line and the rim of what follows it cut in, and how the vertices between move.
struct Reach {
  mesh::TriMesh mesh;  ///< the surface as it was, with more triangles near the line
  struct Moved {
    std::uint32_t vertex = 0;
    ModelPoint by;  ///< for a height of 1; of a line with `to` all of its way
  };
  std::vector<Moved> moved;
  std::vector<std::uint32_t> line;  ///< vertices, from one end to the other
  std::vector<ModelPoint> ring;     ///< where the ring lies; it stays there
  ModelPoint out;                   ///< unit: of the surface round the middle of the line; 0 where there is none
};

/// What a pull reaches on a mesh, but for its height. Smooth: minimises the squared Laplacian of the displacement,
/// which is 0 at the radius and as told on the line, as are its first derivatives across both (k_b d'''' = 0, eq. 5 of
/// the paper on a surface); crease: minimises its gradient. Across a straight line on a plane the displacement is h·(1
/// − 3t² + 2t³) and h·(1 − t), t = distance / radius. A radius that the whole mesh lies within is taken smaller.
/// With a ring (a bump) the displacement is 0 there, and smooth over the line; crease: its slope at the ring is free.
/// Of a single place with a height, that of a plate under an even pressure: h·(1 − s²)² and h·(1 − s²)(3 − s²)/3 within
/// a circle, s = distance / radius. `mesh`: closed, with positions and triangles; uv is interpolated. Empty `moved`:
/// nothing to move. Errors: OutOfMemory. Cost: that of a sparse factorisation over the vertices within the radius.
Result<Reach> reachOf(const mesh::TriMesh& mesh, const Pull& pull);

/// Moves the mesh of a reach all of its way. Cost: that of a copy.
void moveMesh(const Reach& reach, const Pull& pull, mesh::TriMesh& out);
/// The same; if it would then go through itself and did not before, by a half, up to four times, or not at all. What
/// was kept of the way: 1 … 0.
double pullMesh(const Reach& reach, const Pull& pull, mesh::TriMesh& out);

}  // namespace spineloft::pull
