// How far outlines are from lying in planes, as an energy of their depths.
#pragma once

#include <span>
#include <vector>

#include "engine/base/vec.h"
#include "engine/geometry/qp.h"

namespace spineloft::descriptive {

/// Control points of the outlines of one piece.
struct ControlLoops {
  std::vector<SectionPoint> points;  ///< all outlines one after the other, in shares of the drawing's size
  std::vector<std::size_t> sizes;    ///< ≥ 3 each
  std::vector<bool> isFold;          ///< no window crosses it
};

/// The entries of H, lower triangle, of E = α · 8/|W| · Σ_w |R_w z_w|² / (r_w² m_w) = zᵀHz over windows w of m points
/// with the radius r: R projects off the planes z = ax + by + c (paper, eq. 4 to 6), by the singular values of P above
/// kRank of the largest, so that collinear points are held on a line in space. Windows at four scales: the whole run
/// between folds (without folds: all outlines together), halves, quarters and eighths of a run, half overlapping, ≥ 4
/// points. z in shares of the size. The value does not depend on how densely a line is sampled.
std::vector<geometry::QpEntry> planarityEnergy(const ControlLoops& loops, double alpha);

inline constexpr double kRank = 1e-3;

}  // namespace spineloft::descriptive
