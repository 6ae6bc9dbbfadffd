// What the benchmark's ablation exchanges inside a trace to measure its worth. The product never does.
#pragma once

namespace spineloft::ribs {

struct TraceVariant {
  bool euclidean = false;  ///< curves of the Euclidean distance d∞ instead of d2 (traceStraightCurves)
  bool sampled = false;    ///< the paper's Algorithm 1 instead of the exact optimum (algorithmOne)
  bool nearest = false;    ///< no outer hypothesis (tryOuterHypothesis)
  bool alone = false;      ///< no ensemble: the stroke alone
  bool operator==(const TraceVariant&) const = default;
};

}  // namespace spineloft::ribs
