// SpineLoft's Algorithm 1 (sampled and greedy), as the rival of the exact optimum in tests and in the ablation of the
// benchmark; nothing else calls it. As printed it accepts no candidate. In the readable version a rib joins when it
// *adds* less than 1 to the penalty of the set (method: "Rib lengths").
#pragma once

#include <cstdint>

#include "engine/ribs/labels/rib_lengths.h"

namespace spineloft::accuracy {

struct AlgorithmOneParams {
  int iterations = 100;     ///< random subsets drawn
  double startShare = 0.1;  ///< of the rib ends that a random subset begins with
  double threshold = 0.3;   ///< share of the ends a grown subset must hold to be a candidate
  std::uint64_t seed = 1;
};

/// The labels that Algorithm 1 finds: candidate ribs are the local minima of the unary costs along
/// each curve; a grown set is completed by interpolating labels along its side. Falls back to the
/// largest set grown when none passes the threshold. Labels are always reachable ones.
ribs::LengthLabels algorithmOne(const ribs::LengthProblem& problem, const AlgorithmOneParams& params);

}  // namespace spineloft::accuracy
