// Ribs of a stroke that is still being drawn. What was learned of the object a few moves ago replaces most of the
// search.
#pragma once

#include <vector>

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/ribs/base/spine.h"
#include "engine/ribs/search/ribs.h"
#include "engine/ribs/search/workspace.h"

namespace spineloft::ribs {

/// What a search learned of an object, over the arc length of its spine. Picture pixels.
struct Learned {
  Spine spine;         ///< where it learned it, ≥ 2 points; empty: nothing is known
  double studied = 0;  ///< length of that spine
  double length = 0;   ///< that the tables cover; what lies beyond `studied` is extrapolated by pass 3
  double lean = 0;     ///< of the even part that explains the picture best (lean.h)
  /// Evenly over the length: widths of that part, and where the ends stand, in stiff lines.
  std::vector<float> width, left, right;
  std::vector<float> leftWeight, rightWeight;  ///< weights of the evidence of either side in pass 3
  bool empty() const { return spine.points.empty(); }
};

/// Follows one stroke from move to move. traceRibs makes three passes (ribs.cpp). Passes 1 and 2 only choose between
/// hypotheses and find the width, which hardly changes from one move to the next. A move therefore runs pass 3 alone,
/// on half the labels and no farther out than needed, starting from what was learned. Passes 1 and 2 are repeated
/// meanwhile, one step a move, on the stroke as it was when they began.
///
/// A stroke that is still short, a picture without edges, and a stroke that is not the one followed so far get a
/// whole traceRibs. The result depends only on the moves since the last of those: there is no clock, and equal moves
/// give equal ribs.
class LiveTrace {
 public:
  /// The stroke as it is now. The ribs are near those of traceRibs for the same input, whose laws they
  /// keep, but without confidence and other places; `exact` says whether they are equal to them.
  /// Errors: those of traceRibs.
  struct Ribs {
    RibSet set;
    bool exact = false;
  };
  Result<Ribs> move(const Spine& spine, const PictureEvidence& picture, const RibParams& params);
  /// The same in place of what `set` held, which is of no use after a failure; returns whether the ribs are
  /// exact. A stroke like one that was followed before asks for no memory.
  Result<bool> move(const Spine& spine, const PictureEvidence& picture, const RibParams& params, RibSet& set);

  /// From fewer points than this the search is quick enough.
  static constexpr std::size_t kShort = 60;

 private:
  bool follows(const Spine& spine, const PictureEvidence& picture, const RibParams& params) const;
  bool changed(const Spine& spine) const;
  Status follow(const Spine& spine, const PictureEvidence& picture, const RibParams& params, RibSet& set);
  Status study(const Spine& spine, const PictureEvidence& picture, const RibParams& params);

  Learned learned_, longer_;
  RibParams params_;                                  // of learned_
  image::Size size_;                                  // of its picture
  const void *edges_ = nullptr, *ignored_ = nullptr;  // whose evidence; compared only
  int step_ = 0;                                      // of passes 1 and 2 being repeated, 0: none
  RibWorkspace now_, looks_;
  Progress unwatched_;
};

}  // namespace spineloft::ribs
