// Cutting the inside of a loop into cells, one for each of several curves beyond it. Internal to stack/.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/stack/fork.h"

namespace spineloft::stack {

/// A half-space: normal · (p − origin) ≤ 0.
struct HalfSpace {
  ModelPoint origin, normal;
};

/// The part of a stem that becomes one branch.
struct Cell {
  std::size_t branch = 0;
  std::vector<ModelPoint> points;
  RingVertices vertices;
  std::vector<ModelPoint> ways;   ///< where the surface leaves at each point; not of unit length on cuts
  std::vector<HalfSpace> within;  ///< in which it stays
};

/// The cells of all branches, by a tree of cuts; new vertices on the cuts go into the skin.
std::vector<Cell> cellsOf(const Joint& joint, Skin& skin);

}  // namespace spineloft::stack
