// Ribs of a stroke that is still under the pen: what was learned of the object a few moves ago spares
// most of the search.
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
  double length = 0;   ///< that the tables are of: what was followed beyond it is known less surely
  double lean = 0;     ///< of the even part that explains the picture best (lean.h)
  /// Evenly over the length: widths of that part, and where the ends stand, in stiff lines.
  std::vector<float> width, left, right;
  std::vector<float> leftWeight, rightWeight;  ///< what the evidence of either side counts for in the third look
  bool empty() const { return spine.points.empty(); }
};

/// Follows one stroke from move to move. A traceRibs takes three looks at the colours; the first two
/// only find out which of several parts the stroke means, and how wide it is, and that is nearly the
/// same one move later. So a move takes the third look alone, on half the labels and no farther out than it
/// needs, and starts it from what was learned. Meanwhile the first two looks are
/// taken again, a step with every move, on the stroke as it was when they began.
///
/// A stroke that is short yet, a picture without edges, and a stroke that is not the one followed so far,
/// get a whole traceRibs. What comes out depends on nothing but the moves since the last of those: no
/// clock, and equal moves give equal ribs.
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
  int step_ = 0;                                      // of the looks being taken, 0: none
  RibWorkspace now_, looks_;
  Progress unwatched_;
};

}  // namespace spineloft::ribs
