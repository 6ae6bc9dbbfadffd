// Chords: where the sections of a loft stand, seen from the front, and their repair. Internal to
// loft/.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/base/vec.h"

namespace spineloft::loft {

/// A section seen from the front: a straight line from its left end to its right end, left as seen
/// in the direction in which the chords follow each other. Picture pixels.
struct Chord {
  PicturePoint left, right;
  double at = 0;  ///< its share of the spine's length; caps have that of their end
  PicturePoint middle() const { return (left + right) / 2; }
  PicturePoint across() const { return right - left; }
  double width() const { return distance(left, right); }
  bool operator==(const Chord&) const = default;
};

/// The direction of travel at right angles to a chord's `across` (y down: left of travel is left).
inline PicturePoint forwardOf(PicturePoint across) { return {across.y, -across.x}; }

/// What counts as too close, in picture pixels, both > 0.
struct ChordLimits {
  double spacing = 0;  ///< ends of neighbouring chords are at least this far apart
  double width = 0;    ///< chords are at least this wide
};

/// Twice the signed area swept from a to b: positive when b follows a.
double sweptArea(const Chord& a, const Chord& b);

/// Whether b may follow a: the chords do not cross, do not turn about, and b lies ahead.
bool follows(const Chord& a, const Chord& b, const ChordLimits& limits);

/// Narrow chords grow about their middle to the least width; chords without a direction take that
/// of the line of middles.
void widenChords(std::vector<Chord>& chords, const ChordLimits& limits);

/// Keeps the longest run of chords that follow each other. Of the others, the end that is in the
/// way moves onto the line between its neighbours' ends; what still crosses is dropped. Where most
/// cross (a bend tighter than the part is wide) the ends that run backwards first gather in one
/// place. Ends that coincide with their predecessor's move ahead by `spacing`. Chords that already
/// follow each other come back unchanged. Afterwards chords up to eight places apart do not cross,
/// but for a few `spacing` at ends that coincided. Cost: linear, with a bounded look at neighbours.
std::vector<Chord> orderChords(std::vector<Chord> chords, const ChordLimits& limits);

/// What it looks for the run in.
struct ChordMemory {
  /// Ends of neighbouring chords that gather in one place.
  struct Block {
    PicturePoint sum;
    std::size_t first, count;
    PicturePoint mean() const { return sum / static_cast<double>(count); }
  };
  std::vector<std::size_t> length, previous, run;
  std::vector<Chord> kept, out;
  std::vector<Block> blocks;
};
/// The same in place, in memory that is reused.
void orderChords(std::vector<Chord>& chords, const ChordLimits& limits, ChordMemory& memory);

/// Moves both ends of every chord strictly ahead of its predecessor (by `spacing`, measured across
/// both chords), dropping what would have to move by more than a quarter of its width.
void spreadChords(std::vector<Chord>& chords, const ChordLimits& limits);

}  // namespace spineloft::loft
