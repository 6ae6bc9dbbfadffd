// Ends that are cut straight across where the spine ends. Internal to loft/, and for outlines on screen.
#pragma once

#include <vector>

#include "engine/loft/chords.h"
#include "engine/loft/loft.h"
#include "engine/ribs/base/rib_set.h"

namespace spineloft::loft {

/// How far rib ends may reach beyond the end of the spine before a flat end is cut, in half widths of
/// the chord that is left: ribs of an end that is flat in the picture reach a little beyond it.
inline constexpr double kFlatSlack = 0.25;

/// Ribs near the end of a wide part bend round that end (the curves of the d2 field do), so that the last
/// chord is narrow and far beyond the spine. A flat or open end is cut square to the spine instead,
/// where the spine ends: chords beyond it go, the cut becomes the last one. `chords` are those of `set`,
/// picture pixels, in its order. Untouched: round and pointed ends, ends whose ribs do not reach
/// kFlatSlack beyond on both sides (slanted ribs do on one), ribs without a finite centre, and parts of which fewer
/// than two chords would stay.
void cutStraightEnds(std::vector<Chord>& chords, const ribs::RibSet& set, const LoftParams& params);

}  // namespace spineloft::loft
