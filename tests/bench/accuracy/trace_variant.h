// A trace with one of its stages exchanged or left out, to measure what the stage is worth.
#pragma once

#include "engine/base/progress.h"
#include "engine/ribs/search/ribs.h"

namespace spineloft::accuracy {

struct TraceVariant {
  bool euclidean = false;  ///< curves of the Euclidean distance d∞ instead of d2 (SpineLoft's figure 17)
  bool sampled = false;    ///< the paper's Algorithm 1 instead of the exact optimum (algorithm_one.h)
  bool operator==(const TraceVariant&) const = default;
};

/// ribs::traceRibs with stages exchanged, from the same steps (rib_search.h); with none exchanged
/// it is the same. Its laws and errors. The picture has edges.
Result<ribs::RibSet> variantRibs(const ribs::Spine& spine, const ribs::PictureEvidence& picture,
                                 const ribs::RibParams& params, const TraceVariant& variant);

}  // namespace spineloft::accuracy
