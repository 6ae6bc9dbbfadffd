// What the benchmark's ablation exchanges inside a trace to measure its worth. The product never does.
#pragma once

#include "engine/ribs/ribs.h"

namespace spineloft::ribs {

struct TraceVariant {
  bool euclidean = false;  ///< curves of the Euclidean distance d∞ instead of d2 (traceStraightCurves)
  bool sampled = false;    ///< the paper's Algorithm 1 instead of the exact optimum (algorithmOne)
  bool nearest = false;    ///< no look whether the thing goes on beyond the part (tryFarther)
  bool operator==(const TraceVariant&) const = default;
};

/// As traceRibs, with parts exchanged; with none it is traceRibs.
Result<RibSet> traceVariant(const Spine& spine, const PictureEvidence& picture,
                            const RibParams& params, TraceVariant variant, RibWorkspace& memory);

}  // namespace spineloft::ribs
