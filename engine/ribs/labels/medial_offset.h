// How far a stroke is off the middle of the object, and the widths of the object: found for the whole part before its
// details.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/ribs/labels/rib_lengths.h"

namespace spineloft::ribs {

/// A width hypothesis: at rib i the left length is (1 + medialOffset) width/2 and the right one (1 − medialOffset)
/// width/2. `medialOffset` is the medial offset, one for the whole stroke.
struct WidthHypothesis {
  double medialOffset = 0;   ///< −kMostMedialOffset … kMostMedialOffset; > 0: the stroke is nearer to the right side
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

/// The best width hypotheses of clearly different medial offsets, best first: the best offset, and those of the other
/// local minima and the outermost ones of seven offsets that are within `kRunnerUpEnergy` per rib of it;
/// kMostRunnersUp in all. A narrow part between one edge near the stroke and some inner line is often as good a chain
/// as the true one; the colours inside decide later.
///
/// Exact for each offset tried (a chain over widths); each hypothesis is the best of its neighbourhood, refined
/// twice. An offset costs `medialOffsetCost` · |medialOffset| per rib. Widths lie on a geometric grid from `narrowest`
/// to the widest that any rib reaches. The opposite costs of the problem are not used. Replaces `parts`, reusing
/// memory.
void fitWidthHypotheses(const LengthProblem& problem, double narrowest, double medialOffsetCost,
                        LengthWorkspace& workspace, WidthHypotheses& parts);
inline constexpr double kRunnerUpEnergy = 0.25;

}  // namespace spineloft::ribs
