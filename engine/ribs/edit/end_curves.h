// Rib ends told beside the gradient curves of their spine: a rib that was found in a picture ends on its curve, so that
// one number tells nearly all of where.
#pragma once

#include <vector>

#include "engine/image/image.h"
#include "engine/ribs/base/spine.h"
#include "engine/ribs/edit/places.h"
#include "engine/ribs/field/curves.h"

namespace spineloft::ribs {

/// Both in picture pixels.
struct EndOnCurve {
  double beside = 0;  ///< in the drawing direction, from the point of the curve that is as far out
  double length = 0;  ///< of the curve up to there; below 0 behind the spine
};

/// The curves of both sides of a spine, in the frames of its points (EndEdit::along, EndEdit::out), as far as they lead
/// outwards; from there on, and behind the spine, they go straight. So each place in a frame is told by one pair of
/// numbers. A difference of either number moves an end by at most as much. Cost: one tracing of the curves.
///
/// Share texts are told by these curves from version 3 on: whoever changes cleanSpine, the field or the tracing changes
/// what they say (tests/golden/share-v3 and -v4), and has to keep the curves of today for them.
class EndCurves {
 public:
  /// A spine that cleanSpine made in a picture of this size.
  EndCurves(const Spine& spine, image::Size picture);
  /// `end` is at the point `rib` of the spine; `length` is a multiple of `step` > 0.
  EndOnCurve tell(std::size_t rib, const EndEdit& end, double step) const;
  /// Sets EndEdit::along and EndEdit::out. What `tell` gave gives the same end again.
  void put(std::size_t rib, const EndOnCurve& told, EndEdit& end) const;

 private:
  struct Line {
    std::vector<PicturePoint> points;  ///< along, out; `out` grows; ≥ 2 points
    std::vector<double> lengths;       ///< of the line up to each
  };
  const Line& lineOf(std::size_t rib, Side side) const;
  static Line lineAt(const Ruler& ruler, const GradientCurves& curves, std::size_t rib, Side side);

  std::vector<Line> lines_;  ///< all left ones first
};

}  // namespace spineloft::ribs
