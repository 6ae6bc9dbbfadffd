// A region under a soft, inflated surface: its triangulation, and how high the surface is.
#pragma once

#include <vector>

#include "engine/geometry/refine.h"
#include "engine/geometry/region.h"

namespace spineloft::inflate {

/// A mesh with the solution of the Poisson equation at its points: the surface is √u high (poisson_height.h).
struct Cushion {
  geometry::PlaneMesh mesh;  ///< constrained Delaunay
  std::vector<double> u;     ///< square pixels; empty when the mesh or the solution cannot be made
};

/// The first, coarse solution has this much of the spacing.
inline constexpr double kCoarse = 1.8;

/// Of points on a surface of about `points` over an area of square pixels, both sides together; pixels.
double cushionSpacing(double area, int points);

/// Points of an even spacing in the plane. `region`: planeRegion of sampled contours.
Cushion evenCushion(const geometry::PlaneRegion& region, double spacing);

/// Points as dense as the surface height · √u over the coarse solution wants them: rows along the rim where it is
/// steep.
Cushion fineCushion(const geometry::PlaneRegion& region, const Cushion& coarse, double height, double spacing);

}  // namespace spineloft::inflate
