// Two smooth numbers at every place of a region: the share of the way from its skeleton to its outline, and the half
// width there.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/result.h"
#include "engine/geometry/refine.h"
#include "engine/inflate/skeleton.h"

namespace spineloft::inflate {

/// On a triangulation of one piece of a region, whose rim are its outlines and which has the skeleton among its edges.
/// One value a point of the mesh. Each component of the region without the skeleton is a ring that
/// one outline bounds; for every level 0 < c < 1 the set s = c is one closed line in each of them.
struct Fields {
  geometry::PlaneMesh mesh;
  std::vector<std::size_t> sizes;                   ///< corners of each outline of the rim
  std::vector<std::array<std::uint32_t, 2>> bones;  ///< edges of the skeleton; none: `onBone` has one point
  std::vector<char> onBone;                         ///< by point: on the skeleton
  std::vector<double> s;                            ///< 0 on the skeleton … 1 on the outline
  std::vector<double> half;                         ///< H, pixels
  std::vector<Over> over;                           ///< as at the nearest place of the skeleton
  std::vector<double> away;                         ///< distance to the skeleton, pixels
  std::vector<double> toRim;                        ///< distance to the outline, pixels
  std::vector<SectionPoint> rise;                   ///< gradient of s, off skeleton and rim; none: s is linear
  std::vector<SectionPoint> widening;               ///< gradient of H
  std::vector<std::uint32_t> side;                  ///< by triangle: in the ring of which outline
  double spacing = 0;                               ///< of the points, pixels
  double reach = 0;                                 ///< pixels; 0: none, see withReach
  /// What is one half width of a slice where H is h.
  double widthOf(double h) const { return reach > 0 ? std::min(h, reach) : h; }
};

/// s and H on about 1,000 points. s² has a Laplacian that is smoothed from that of d_S/(d_S + d_R), the distances to
/// skeleton and outline, over 0.15 half widths, so that s is exact on discs, strips and rings, and s² has no crease
/// elsewhere; H is the radius of the nearest point of the skeleton, and Over that of it, smoothed in the same way. Ends
/// of the skeleton nearer to the outline than 1.5 spacings are left out. Where the skeleton cannot be edges of so
/// coarse a mesh, a finer one is taken. `fineness`: of the spacing, see finenessFor. Errors: RegionTooFine.
Result<Fields> fieldsOf(const geometry::Contours& piece, const Skeleton& skeleton, double fineness = 1);

/// The same with an s that grows from 0 to 1 over the last `reach` pixels before the outline, wherever the region is so
/// wide: min(s, 1 − d_R/reach), ≤ 0 within. A flood leaves it no extremum off skeleton and outline, so that for every
/// level 0 < c < 1 the set s = c is one closed line for every outline as well.
Fields withReach(Fields fields, double reach);

std::size_t bytesOf(const Fields& fields);

/// A place on a line of equal s.
struct LevelPoint {
  SectionPoint at;
  double half = 0;  ///< H there
  Over over = {};
  double away = 0;  ///< from the skeleton
};
LevelPoint levelPointOf(const Fields& fields, std::uint32_t point);
LevelPoint lerp(const LevelPoint& a, const LevelPoint& b, double t);
struct LevelLine {
  std::uint32_t side = 0;          ///< the outline that it goes round with
  std::vector<LevelPoint> points;  ///< closed; the skeleton on its right, the outline on its left
};
/// All lines where s is the sum of the slices' `levels` by their shares, 0 < level < 1. Where that is the same
/// everywhere: one an outline.
std::vector<LevelLine> levelLines(const Fields& fields, std::span<const double> levels);

}  // namespace spineloft::inflate
