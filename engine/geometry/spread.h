// Points spread over a region, for surfaces above it: near the rim as dense as the surface is steep.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "engine/geometry/refine.h"

namespace spineloft::geometry {

/// How a surface stands over a plane region.
struct SurfaceOver {
  /// Distances from the rim at which rows of points follow it, for each corner of the rim; growing.
  std::function<std::vector<double>(std::size_t corner)> rows;
  std::function<double(SectionPoint)> height;  ///< over a point
};

/// How far points lie from each other on the surface, about.
struct Spacing {
  double rows = 1;     ///< those of the rows
  double lattice = 1;  ///< and all others; not less
};

/// Adds points to a mesh of a region that has only its rim: rows along it, then a triangular lattice,
/// each only where it is the spacing · kNearest away from all others, measured on the surface. Ends with
/// splitChords. `sizes`: corners of each outline, as the mesh was made of.
void spreadPoints(PlaneMesh& mesh, std::span<const std::size_t> sizes, Spacing spacing,
                  const SurfaceOver& surface);

inline constexpr double kNearest = 0.62;

/// Distance from a point to the rim of a mesh, given its outlines.
double distanceToRim(std::span<const SectionPoint> rim, std::span<const std::size_t> sizes,
                     SectionPoint p);

}  // namespace spineloft::geometry
