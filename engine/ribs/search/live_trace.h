// Ribs of a stroke that is still being drawn.
#pragma once

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/ribs/base/spine.h"
#include "engine/ribs/search/ribs.h"
#include "engine/ribs/search/workspace.h"

namespace spineloft::ribs {

/// traceRibs with at most 51 ribs, between which the others are filled in: the network has no more rows for them. It
/// remembers nothing but memory: equal moves give equal ribs.
class LiveTrace {
 public:
  /// The stroke as it is now. The ribs are near those of traceRibs for the same input, whose laws they
  /// keep, but without confidence and other places; `exact` says whether they are equal to them, which they are where
  /// nothing is known of the picture. Errors: those of traceRibs.
  struct Ribs {
    RibSet set;
    bool exact = false;
  };
  Result<Ribs> move(const Spine& spine, const PictureEvidence& picture, const RibParams& params);
  /// The same in place of what `set` held, which is of no use after a failure; returns whether the ribs are
  /// exact. A stroke like one that was followed before asks for no memory.
  Result<bool> move(const Spine& spine, const PictureEvidence& picture, const RibParams& params, RibSet& set);

 private:
  RibWorkspace memory_;
  Spine few_;
  RibSet fewRibs_;
  Progress unwatched_;
};

}  // namespace spineloft::ribs
