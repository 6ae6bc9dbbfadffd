// A stroke that was drawn past the ends of a thing, cut to what lies on it: the mistake that is made most, and
// ribs over the ground beside a thing cost more of a part than the widest wobble.
#pragma once

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

/// Which stretch of a spine lies on the thing under its middle. An end is beyond the thing where
/// - the colours along it are those found around the thing and, from a place on, those of its middle; or
/// - it is blank, ribs there stand on nothing, and at a place it crosses a line behind which they do
///   (ink on paper, where colours say nothing).
/// The stretch ends a third of a half width before that place, as a careful stroke would. Where that is
/// not clear, or little would be left, it is the whole spine. Looked for up to three half widths or two
/// fifths of the spine from either end. Costs one traceRibs, whose errors it has.
Result<SpineStretch> stretchOnThing(const Spine& spine, const PictureEvidence& picture, const RibParams& params,
                                    RibWorkspace& memory);

/// The points of a stroke (picture pixels) that lie on the thing, with new ends where it was cut; the stroke
/// itself where nothing is to be cut, nothing is known of the picture or it makes no spine.
std::vector<PicturePoint> strokeOnThing(std::span<const PicturePoint> stroke, const PictureEvidence& picture,
                                        const SpineParams& spine, const RibParams& ribs);

}  // namespace spineloft::ribs
