// One step along a chain of ribs: the min-convolution with the neighbour cost. Shared by the
// searches over rib lengths (rib_lengths.h), their bounds and the chains over widths.
#pragma once

#include <vector>

#include "engine/ribs/labels/rib_lengths.h"

namespace spineloft::ribs {

/// What one step needs to know about one side. Places are those of a run of labels of either rib.
struct MinPlusStep {
  const float* to;    ///< of the rib that is stepped onto
  const float* from;  ///< of the rib that is left
  float slope;        ///< weight / spacing
  float free;         ///< freedom · spacing
  float cap;
};

/// From rib − 1 to `rib` ≥ 1, labels from 0 on.
MinPlusStep stepTo(const LengthProblem& problem, const SideCosts& side, int rib);
/// The same step backwards, from `rib` to rib − 1.
MinPlusStep stepFrom(const LengthProblem& problem, const SideCosts& side, int rib);

/// out(k, ·) = min over k' of in(k', ·) + min(cap, slope · max(0, |to_k − from_k'| − free)), for
/// `width` columns at once; `fromCount` rows in, `toCount` rows out. The cost is flat in a window
/// and linear outside, so the minimum is the least of a window minimum, a running minimum from
/// either side, and the overall minimum plus cap.
struct MinPlusRows {
  int fromCount = 0, toCount = 0, width = 0;
};
void convolveRows(const MinPlusStep& step, const MinPlusRows& rows, const float* in, float* out, StepScratch& scratch);

/// Where the costs of a step are read and written: `problem.levels` entries each, apart.
struct CostLine {
  const float* in;
  float* out;
};

/// Opposite cost of one pair of labels of a rib.
float oppositeCost(const LengthProblem& problem, int rib, std::size_t left, std::size_t right);
/// Adds to the costs of the labels of one side what they cost opposite label `other` of the other side.
void addOpposite(const LengthProblem& problem, int rib, bool ofLeft, std::size_t other, float* costs);
/// The least opposite cost of every label of one side plus what is given for the labels of the other:
/// out(l) = min over r of cost(l, r) + in(r); `in` is kUnreachable where there is no such label.
/// O(levels) for a medial offset alone.
void leastOpposite(const LengthProblem& problem, int rib, bool ofLeft, CostLine line, StepScratch& scratch);

}  // namespace spineloft::ribs
