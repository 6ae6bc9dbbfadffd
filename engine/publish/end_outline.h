// The outline of an end of a loft as a link has room for it. Internal to publish/.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/base/vec.h"
#include "engine/ribs/edit/edits.h"

namespace spineloft::publish {

/// Both ends of a rib, picture pixels.
struct RibEnds {
  PicturePoint left, right;
};

/// The outermost rib of an end and the one before it.
struct EndRibs {
  RibEnds last, before;
  bool atStart = false;
};

/// An outline of an end in the frame of its rib, and how far it is from the one found at most, picture pixels.
struct EndOutline {
  std::vector<ribs::RibPoint> points;
  double off = 0;
};

/// An outline that is at most one step of a text's grid off, and behind it others that are told in fewer and fewer
/// characters (io/share_ends.h). `found`: from the left round to the right of `foundRibs`, picture pixels;
/// outlines are beside `toldRibs`. `step`: a text tells each coordinate of a point as a multiple of it, picture pixels.
///
/// A point costs one number where the smooth curve that a loft draws through `found` crosses one of the rays on which a
/// text expects points, and two elsewhere: those of `found` themselves. Outlines have an odd number of points, since a
/// cap ends at the middle one (loft/caps.h). None on a rib that is as good as a point, which is where the part ends;
/// one point behind the rib where the middle one is not beyond it: the part ends at the rib then.
std::vector<EndOutline> endOutlines(const std::vector<PicturePoint>& found, const EndRibs& foundRibs,
                                    const EndRibs& toldRibs, double step);

}  // namespace spineloft::publish
