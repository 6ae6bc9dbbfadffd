// What a hand does to ribs, as functions from edits to edits: the tools of the page call them while a
// gesture goes on (preview) and when it ends (action). `ribs` are always the ribs as seen, that is
// applyEdits(spine, generated, edits); all points and distances are picture pixels. A gesture that
// goes on is best given the scene as it was when the gesture began: then changing the reach on the
// way leaves nothing behind. An index out of range, a point that is not finite or a list of edits
// that is full changes nothing.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "engine/ribs/edit/edits.h"

namespace spineloft::ribs {

/// One end of one rib, by its index in the RibSet that is seen.
struct EndRef {
  std::size_t rib = 0;
  Side side = Side::Left;
  bool operator==(const EndRef&) const = default;
};

/// What gestures look at. References must outlive the call.
struct EditScene {
  const Spine& spine;
  const RibSet& ribs;
  const RibEdits& edits;
};

/// The end nearest to `p` within `within`; none elsewhere.
std::optional<EndRef> nearestEnd(const RibSet& ribs, PicturePoint p, double within);
/// The rib whose line comes nearest to `p` within `within`; none elsewhere.
std::optional<std::size_t> nearestRib(const RibSet& ribs, PicturePoint p, double within);
/// Place on the spine nearest to `p`, as a share of its length, 0…1.
double placeOf(const Spine& spine, PicturePoint p);
/// Place of a rib on the spine: that of its centre.
double placeOf(const EditScene& scene, std::size_t rib);

/// The end goes to `to`; the ends of its side within `reach` (share of the length; 0: it alone, that
/// is, up to the ribs beside it) follow softly. Dragging an end again with the same reach replaces
/// its last edit unless another edit that reaches the same ends came in between, so that a drag is
/// one edit however long. A locked end goes alone and stays locked.
RibEdits dragEnd(const EditScene& scene, EndRef end, PicturePoint to, double reach);

/// A line drawn near the ends of ribs: which ends it touches, and the edits that bring them to it.
struct StrokeDeform {
  std::vector<EndRef> touched;  ///< the ends that move, rib after rib, the left one first
  RibEdits edits;
};
/// Ends move along their ribs to where the stroke crosses the rib (or its extension) within `within`
/// of the end (where it does so several times, to the crossing nearest to the end); locked ends stay.
/// With `bothSides` the opposite ends change by the same ratio, and count as touched.
StrokeDeform deformByStroke(const EditScene& scene, std::span<const PicturePoint> stroke, double within,
                            bool bothSides);

/// Holds or frees both ends of a rib (hold: they stay where they are now, whatever is found later;
/// free: they stay until something moves them).
RibEdits lockRib(const EditScene& scene, std::size_t rib, bool locked);
/// One more rib at the place on the spine nearest to `p`; where there is one already, in the wider of
/// the gaps beside it. A rib that was left out there comes back.
RibEdits addRib(const EditScene& scene, PicturePoint p);
/// Leaves a rib out, and what was done to it alone; the last two ribs stay.
RibEdits removeRib(const EditScene& scene, std::size_t rib);
/// Takes back what was done by hand to this rib.
RibEdits resetRib(const EditScene& scene, std::size_t rib);

/// Moves the end to its `other`-th other place (OtherPlaces of the rib). With `likeNeighbours` the
/// ends beside it that have another place in line with it go along, as far as the line continues.
RibEdits takeOtherPlace(const EditScene& scene, EndRef end, int other, bool likeNeighbours);

}  // namespace spineloft::ribs
