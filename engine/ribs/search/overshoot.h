// Cuts a stroke that runs past the ends of an object. This is the most frequent mistake, and ribs over the background
// cost a part more accuracy than any wobble of the stroke.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/base/result.h"
#include "engine/ribs/base/spine.h"
#include "engine/ribs/search/ribs.h"

namespace spineloft::ribs {

/// Shares of a spine's length, 0 ≤ from < to ≤ 1.
struct SpineStretch {
  double from = 0, to = 1;
  bool whole() const { return from <= 0 && to >= 1; }
  bool operator==(const SpineStretch&) const = default;
};

/// The stretch of a spine that lies on the object under its middle. An end is beyond the object where
/// - the colours along it are those found around the object and, from some place on, those of its middle; or
/// - the ribs there stand on no edges, and the spine crosses a line behind which they do (ink on paper, where colours
///   do not help).
/// The stretch ends a third of a half width before that place, as a careful stroke would. It is the whole spine where
/// the case is not clear or little would be left. Searched up to three half widths or two fifths of the spine from
/// either end. Costs one traceRibs, whose ribs it leaves in `set`, and has its errors.
Result<SpineStretch> stretchOnThing(const Spine& spine, const PictureEvidence& picture, const RibParams& params,
                                    RibWorkspace& memory, RibSet& set);

/// A stroke's spine and its ribs: those of traceRibs.
struct TracedStroke {
  Spine spine;
  RibSet ribs;
};

/// The points of a stroke (picture pixels) that lie on the object, with new ends where it was cut. The stroke itself
/// where there is nothing to cut, the picture has no edges, or the stroke gives no spine. `whole` becomes what was
/// traced on the way where that is the stroke's own: it need not be traced again.
std::vector<PicturePoint> strokeOnThing(std::span<const PicturePoint> stroke, const PictureEvidence& picture,
                                        const SpineParams& spine, const RibParams& ribs, RibWorkspace& memory,
                                        std::optional<TracedStroke>& whole);
std::vector<PicturePoint> strokeOnThing(std::span<const PicturePoint> stroke, const PictureEvidence& picture,
                                        const SpineParams& spine, const RibParams& ribs);

}  // namespace spineloft::ribs
