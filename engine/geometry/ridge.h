// Where the distance to an outline has ridges and fans: along the lines that are equally near to
// two of its sides, and round the corners that point inwards.
#pragma once

#include <span>
#include <vector>

#include "engine/geometry/spread.h"

namespace spineloft::geometry {

/// Points that a surface over a region needs whose height depends on the distance to the rim up to
/// `reach`: on the ridges that are nearer than that, from sharp corners on about every `spacing`,
/// and on arcs round inward corners at the distances `rows`. Rim, sizes and distances as for
/// spreadPoints. Corners count when they turn by more than kSharpTurn. Linear in the corners, times
/// the cost of a distance.
struct RidgeWish {
  double reach = 0, spacing = 1;
  std::span<const double> rows;
};
std::vector<SectionPoint> ridgePoints(std::span<const SectionPoint> rim, std::span<const std::size_t> sizes,
                                      const RimDistance& distances, const RidgeWish& wish);

inline constexpr double kSharpTurn = 0.35;  ///< radians

/// Flips edges of the mesh where the other diagonal lies nearer to the surface `height`, so that
/// edges run along its ridges instead of across them. `tolerance`: a smaller gain is none. Edges
/// between points of equal height `top` are left alone: there the surface is flat.
void flipToSurface(PlaneMesh& mesh, const std::function<double(SectionPoint)>& height, double top, double tolerance);

}  // namespace spineloft::geometry
