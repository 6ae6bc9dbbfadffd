// How far off the middle a stroke was drawn: the symmetry of the whole part before its details.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/ribs/labels/rib_lengths.h"

namespace spineloft::ribs {

/// The even part that explains the evidence best: at rib i the left length is (1 + lean) width/2
/// and the right one (1 − lean) width/2, with one lean for the whole stroke.
struct WidthHypothesis {
  double lean = 0;           ///< −kMostMedialOffset … kMostMedialOffset; > 0: the stroke is nearer to the right side
  std::vector<float> width;  ///< of every rib, in the problem's unit of place, > 0
  double energy = 0;         ///< unary and neighbour terms of both sides
};

inline constexpr std::size_t kMostRunnersUp = 3;
struct WidthHypotheses {
  std::array<WidthHypothesis, kMostRunnersUp> all;
  std::size_t count = 0;  ///< ≥ 1 once found
  std::span<const WidthHypothesis> span() const { return {all.data(), count}; }
};

/// A stroke is taken to be at most a quarter of the width off the middle.
inline constexpr double kMostMedialOffset = 0.5;

/// The best even parts of clearly different leans, best first: the best lean, and of the other local
/// minima and outermost ones among seven leans those within `kRunnerUpEnergy` per rib of it, kMostRunnersUp
/// in all.
/// A narrow part between the stroke's near edge and some inner line is often as good a chain as the
/// true one; which of them it is shows when the colours inside are known.
///
/// Exact for each lean tried (a chain over widths); each part is the best of its neighbourhood,
/// refined twice. A lean costs `medialOffsetCost` · |lean| per rib. Widths are tried on a geometric grid from
/// `narrowest` up to the widest that any rib reaches. Opposite costs of the problem are not used.
/// Replaces `parts`, reusing memory.
void fitWidthHypotheses(const LengthProblem& problem, double narrowest, double medialOffsetCost,
                        LengthWorkspace& workspace, WidthHypotheses& parts);
inline constexpr double kRunnerUpEnergy = 0.25;

}  // namespace spineloft::ribs
