// One step along a chain for a single line of costs: the min-convolution of min_plus_step.h, with the
// windows known beforehand.
#pragma once

#include "engine/ribs/labels/min_plus_step.h"

namespace spineloft::ribs {

/// Costs that rise with the distance from where they stand.
struct SlopedLine {
  const float *in, *place;  ///< costs, and places that increase
  float slope;
};
/// For the minimum over i of in(i) + slope · |x − place(i)|: below[i] is the least of in − slope · place
/// over what comes before i, above[i] that of in + slope · place from i on; n + 1 entries each.
void runningMinima(const SlopedLine& line, std::size_t n, float* below, float* above);

enum class StepWay : std::uint8_t { Forwards, Backwards };

/// The steps along one side (`side` of `problem`: both must outlive it). Plans are kept in the
/// workspace, and made anew only where places, spacings or the freedom are others than last time.
class MinPlusLine {
 public:
  MinPlusLine(const LengthProblem& problem, const SideCosts& side, StepWay way, LengthWorkspace& workspace);

  /// out(k) = min over k' of in(k') + neighbourCost(k', k). Forwards: from rib − 1 to `rib`; backwards: from
  /// `rib` to rib − 1. 1 ≤ rib < ribs. The same as convolveRows with one column, to the last bit.
  void step(int rib, CostLine line) const;

 private:
  const LengthProblem& problem_;
  const SideCosts& side_;
  StepWay way_;
  StepScratch& scratch_;
  const StepPlan* plan_;
};

}  // namespace spineloft::ribs
