// From the outline in the picture to sections in space. Internal to loft/.
#pragma once

#include <optional>
#include <vector>

#include "engine/loft/chords.h"
#include "engine/loft/loft.h"
#include "engine/loft/section_track.h"
#include "engine/loft/sweep.h"

namespace spineloft::loft {

/// All chords of the part in order, and its two ends.
struct Outline {
  std::vector<Chord> chords;
  std::optional<PicturePoint> startTip, endTip;
  bool startOpen = false, endOpen = false;
  std::size_t bodyBegin = 0, bodyEnd = 0;  ///< the chords that are ribs; none when not known
};
std::vector<PicturePoint> middlesOf(const Outline& outline);

/// Direction of the smoothed centre line at each of `middles`; the raw difference where `reach` is
/// 0.
std::vector<PicturePoint> travelAlong(std::span<const PicturePoint> middles, double reach);

/// A section is never flatter than this share of its width: a rib along the centre line would
/// otherwise have no depth at all.
inline constexpr double kLeastDepth = 0.25;

/// What stands along the spine, and where. `spine` may be null (at rest).
struct StationMaker {
  const SectionTrack& track;
  const LoftParams& params;
  const PosedSpine* spine;

  bool moved() const { return spine != nullptr && spine->moved; }
  bool ring() const { return moved() && spine->closed; }
  /// Whether anything depends on the place along the spine.
  bool changes() const;
  Sweep sweep(const Outline& outline) const;
};

}  // namespace spineloft::loft
