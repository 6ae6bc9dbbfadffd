// Cutting the inside of a loop, the stem, into cells, one for each of several curves beyond it, its branches. Internal
// to stack/.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/stack/fork.h"

namespace spineloft::stack {

/// The part of a stem that becomes one branch.
struct Cell {
  std::size_t branch = 0;  ///< which, of those that the stem was cut for
  std::vector<ModelPoint> points;
  RingVertices vertices;
  std::vector<ModelPoint> ways;   ///< where the surface leaves at each point; not of unit length on cuts
  std::vector<HalfSpace> within;  ///< in which it stays
};

struct Cells {
  std::vector<Cell> all;
  double rise = 0;      ///< of the first cut: share of the way to the branches
  RingVertices crease;  ///< the vertices of all cuts between their ends
};

/// The stem as one cell.
Cell wholeOf(const Loop& stem);
/// A cell for each of the branches (≥ 1), which lie ahead along the stem's normal, by a tree of cuts; new vertices on
/// the cuts go into the skin.
Cells cellsOf(const Loop& stem, const std::vector<const Loop*>& branches, Skin& skin);
/// Mean of the points of a closed curve, and the length of its vector area.
ModelPoint middleOf(const std::vector<ModelPoint>& points);
double areaOf(const std::vector<ModelPoint>& points);

}  // namespace spineloft::stack
