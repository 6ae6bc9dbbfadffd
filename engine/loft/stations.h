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

/// A section where it was traced: across its chord, `depth` picture pixels for section y = 1.
struct Flat {
  Chord chord;
  double depth = 0;
};

/// The line through the middles of an outline's chords, from tip to tip.
struct CentreLine {
  std::vector<PicturePoint> middles;
  std::vector<PicturePoint> travel;  ///< its direction at each, smoothed; the raw difference where `reach` is 0
  std::vector<double> weights;
  void follow(const Outline& outline, double reach);
};

/// What StationMaker asks for besides its result.
struct StationMemory {
  CentreLine line;
  std::vector<Flat> flat, refined;
  std::vector<double> depths, weights, changes;
};

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
  /// In place of what `sweep` held.
  void sweep(const Outline& outline, StationMemory& memory, Sweep& sweep) const;
};

}  // namespace spineloft::loft
