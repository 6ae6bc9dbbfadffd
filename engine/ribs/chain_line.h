// One step along a chain for a single line of costs: the min-convolution of chain_step.h, with the
// windows known beforehand.
#pragma once

#include "engine/ribs/rib_lengths.h"

namespace spineloft::ribs {

enum class StepWay : std::uint8_t { Forwards, Backwards };

/// Where the costs of a step are read and written: `problem.levels` entries each, apart.
struct CostLine {
  const float* in;
  float* out;
};

/// The steps along one side (`side` of `problem`: both must outlive it). Plans are kept in the
/// workspace, and made anew only where places, spacings or the freedom are others than last time.
class ChainLine {
 public:
  ChainLine(const LengthProblem& problem, const SideCosts& side, StepWay way,
            LengthWorkspace& workspace);

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
