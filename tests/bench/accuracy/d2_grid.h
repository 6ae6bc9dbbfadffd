// d2 of a polyline on a whole grid of points: exactly, and hierarchically (method: "d2"; far groups
// of segments by moments). The d2 of single points, with gradient, is in d2.h.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/vec.h"

namespace spineloft::accuracy {

/// Grid points `first` + (column, row) · `step`, row-major. Picture pixels; `columns`, `rows` ≥ 1,
/// `step` > 0.
struct GridPlan {
  PicturePoint first;
  double step = 1;
  int columns = 0, rows = 0;
};

/// What an evaluation cost, so that tests can hold it to its promise without a clock.
struct GridWork {
  std::uint64_t segments = 0;  ///< closed forms of one segment at one point
  std::uint64_t groups = 0;    ///< moments of one group at one point
};

/// d2 in picture pixels, columns × rows, in single precision: every segment at every point, within
/// 3e-5 beyond a pixel of the polyline (≥ 2 distinct points). O(segments · points).
GridWork d2OnGrid(std::span<const PicturePoint> polyline, const GridPlan& plan, std::vector<float>& d2);

/// The same within a relative 1e-3 where segments are short (the paper's test), and within 2.5e-3
/// for any line, beyond about a pixel of it: segments in a binary tree of groups with mass and
/// second moments of 1/r², grid points in a quadtree of tiles. What is far from a tile is summed at
/// 4 × 4 Chebyshev points and interpolated (tile to tile, and on the last tile to its points); what
/// is near is passed on to the tile's quarters, and on the smallest tiles summed at every point.
GridWork quickD2OnGrid(std::span<const PicturePoint> polyline, const GridPlan& plan, std::vector<float>& d2);

}  // namespace spineloft::accuracy
