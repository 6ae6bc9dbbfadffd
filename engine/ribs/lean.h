// How far off the middle a stroke was drawn: the symmetry of the whole part before its details.
#pragma once

#include "engine/ribs/rib_lengths.h"

namespace spineloft::ribs {

/// The even part that explains the evidence best: at rib i the left length is (1 + lean) width/2
/// and the right one (1 − lean) width/2, with one lean for the whole stroke.
struct EvenPart {
  double lean = 0;  ///< −kMostLean … kMostLean; > 0: the stroke is nearer to the right side
  std::vector<float> width;  ///< of every rib, in the problem's unit of place, > 0
  double energy = 0;         ///< unary and neighbour terms of both sides
};

/// A stroke is taken to be at most a quarter of the width off the middle.
inline constexpr double kMostLean = 0.5;

/// Exact for each lean tried (a chain over widths), the best of seven leans refined twice. A lean
/// costs `leanCost` · |lean| per rib. Widths are tried on a geometric grid from `narrowest` up to
/// the widest that any rib reaches. Opposite costs of the problem are not used.
EvenPart findEvenPart(const LengthProblem& problem, double narrowest, double leanCost,
                      LengthWorkspace& workspace);

}  // namespace spineloft::ribs
