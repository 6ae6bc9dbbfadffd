// The skeleton of a region: the lines in its middle, without those that only corners and tremor make.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/vec.h"
#include "engine/geometry/region.h"
#include "engine/inflate/inflate_params.h"

namespace spineloft::inflate {

/// What a person wants of the solid over a place of the skeleton; the fields carry it into the region.
struct Over {
  double factor = 1;                         ///< of the thickness
  std::array<double, kMostSlices> share{1};  ///< of each slice, of 1 in all
  bool operator==(const Over&) const = default;
};
Over lerp(const Over& a, const Over& b, double t);

/// A place of the skeleton and its distance to the outline: the radius of the largest disc there that fits.
struct SkeletonPoint {
  SectionPoint at;  ///< pixels, x right, y up
  double radius = 0;
  Over over = {};
  bool operator==(const SkeletonPoint&) const = default;
};

/// A graph in the plane with the holes of the region as its cycles.
struct Skeleton {
  std::vector<SkeletonPoint> points;
  /// Ways through `points` from an end or a fork to the next one. A ring without a fork ends where it begins; a
  /// skeleton of one point is one branch of that point. No two branches have more than ends in common.
  std::vector<std::vector<std::uint32_t>> branches;
  int ends = 0;   ///< points with one neighbour
  int forks = 0;  ///< points with three and more
  int rings = 0;  ///< independent cycles
  bool operator==(const Skeleton&) const = default;
};

/// How much a branch must stand out: more keeps fewer. Corners blunter than 2 asin(1/σ) have no branch.
inline constexpr double kScale = 1.5;

/// The skeleton of one connected piece (geometry::piecesOf): the medial axis of about 600 even samples of its outlines,
/// pruned by the discrete scale axis (Miklós, Giesen and Pauly 2010) from its cycles, or from its largest disc,
/// outwards: what hangs on a kept disc of radius r goes when every disc t of it has distance ≤ σ (r − t) + 0.04 r. So
/// it does not depend on size, place or sampling, and on tremor of a few hundredths of r hardly. Points lie within
/// 0.15 r of each other, smoothed by Taubin's steps (1995). `fineness`: of the samples, see finenessFor. Same input,
/// same result. Error: RegionTooFine.
Result<Skeleton> skeletonOf(const geometry::Contours& piece, double sigma = kScale, double fineness = 1);

/// Counts ends, forks and rings anew.
void countNodes(Skeleton& skeleton);

/// Pixels.
double lengthOf(const Skeleton& skeleton);

}  // namespace spineloft::inflate
