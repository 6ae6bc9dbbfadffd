// How a loft goes on beyond its first and last rib, seen from the front. Internal to loft/.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/loft/chords.h"
#include "engine/loft/loft.h"

namespace spineloft::loft {

/// One end of a loft: more chords beyond the last one, outwards, and the tip that closes them.
/// Without a tip the end is cut off at the last chord.
struct Cap {
  std::vector<Chord> chords;
  std::optional<PicturePoint> tip;
};

/// What a cap continues. For the start of a part, the part is seen from the other end: `flipped`.
struct CapSite {
  Chord last, before;                 ///< the end's chord and its inner neighbour (the same when there is none)
  Chord shoulder;                     ///< an earlier chord, about half the end's width back: the way the sides run
  PicturePoint travel;                ///< unit direction of the centre line there, outwards
  std::span<const PicturePoint> fan;  ///< outline from last.left round to last.right, or empty
};

/// The same chord in the opposite direction of travel.
inline Chord flipped(const Chord& chord) { return {chord.right, chord.left, chord.at}; }

/// What planCap asks for besides its result.
struct CapMemory {
  std::vector<PicturePoint> fan, frame, outline;
};

/// Computes the chords and the tip of a cap, replacing what `cap` held. Empty for Flat and Open, and for Round where
/// the fan ends before the last chord.
struct CapPlan {
  sections::CapStyle style;
  int rings;  ///< LoftParams::capRings
  ChordLimits limits;
};
void planCap(const CapSite& site, const CapPlan& plan, CapMemory& memory, Cap& cap);

}  // namespace spineloft::loft
