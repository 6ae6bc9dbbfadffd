// Solids between two surfaces over one plane region.
#pragma once

#include <span>
#include <vector>

#include "engine/geometry/refine.h"
#include "engine/mesh/front_uv.h"
#include "engine/mesh/tri_mesh.h"

namespace spineloft::mesh {

/// One side: a triangulation of the region, and how high each of its points stands towards the viewer.
struct Side {
  const geometry::PlaneMesh& plane;
  std::span<const double> height;
};

/// The closed solid between a front and a back over the same rim (as many corners, at the same places).
/// At those corners where the two stand apart, a wall joins them; elsewhere they share the corner. Where they stand
/// apart at all, positions are those of the front, then those of the back. Front must be above the back at every inner
/// point. Plane coordinates become x and y; the picture of `width` × `height` pixels gives UV, its
/// pixel centres at integers. `sizes`: corners of each outline of the rim.
TriMesh solidBetween(const Side& front, const Side& back, std::span<const std::size_t> sizes, PictureSize picture);

}  // namespace spineloft::mesh
