// Ribs as values: what a stroke found in a picture.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/base/vec.h"

namespace spineloft::ribs {

/// How sure a rib end is of its place.
enum class RibState : std::uint8_t {
  Edge,     ///< it stands on an edge of the picture
  Bridged,  ///< no edge here, but its neighbours on both sides found one
  Guessed,  ///< no edge nearby: taken from the other side, or from a default width
  Edited,   ///< put there by hand (edits.h)
  Locked,   ///< put there by hand, and later edits near by leave it
};

/// The state in files and in the API: "edge", "bridged", "guessed", "edited" or "locked".
std::string_view ribStateKey(RibState state);

/// Other places where an end might stand: the next-best labels of the optimiser, best first, apart
/// from each other and from the chosen one. Picture pixels.
struct OtherPlaces {
  std::array<PicturePoint, 3> at{};
  int count = 0;
  bool operator==(const OtherPlaces&) const = default;
};

/// One rib: two end points on opposite sides of the spine. Picture pixels. `left` is the side to
/// the left of the drawing direction as seen on the screen. The polyline from `center` to an end
/// along the gradient curve is not kept: seen from the front only the ends matter.
struct Rib {
  PicturePoint center;  ///< on the spine
  PicturePoint left, right;
  RibState leftState = RibState::Guessed, rightState = RibState::Guessed;
  double leftLevel = 0, rightLevel = 0;  ///< d2 at the ends, picture pixels
  /// Margin to the next-best place, 0 (a toss-up) … 1 (no rival).
  double leftConfidence = 0, rightConfidence = 0;
  OtherPlaces leftOthers = {}, rightOthers = {};
  bool operator==(const Rib&) const = default;
};

/// A scribble over edges that are not to count. Picture pixels.
struct IgnoreMark {
  std::vector<PicturePoint> stroke;  ///< ≥ 1 point
  double radius = 8;                 ///< 0.5…500
  bool covers = false;               ///< an occluder is under it, whose colours are on no part
  bool operator==(const IgnoreMark&) const = default;
};
inline constexpr std::size_t kMostIgnoreMarks = 500;

/// The ends of the fan of gradient curves around one end of the spine, from the left rib's side
/// round to the right's: the outline of a round cap. Empty when the fan was not traced. Picture
/// pixels.
struct EndFan {
  std::vector<PicturePoint> points;
  bool operator==(const EndFan&) const = default;
};

/// The energy of SpineLoft 3.3.2 by term, summed over all ribs (dimensionless).
struct EnergyTerms {
  double distance = 0, neighbour = 0, opposite = 0;
  double total() const { return distance + neighbour + opposite; }
  bool operator==(const EnergyTerms&) const = default;
};

/// Ribs in order along the spine, and the fans around its first and last point.
struct RibSet {
  std::vector<Rib> ribs;
  EndFan startFan, endFan;
  EnergyTerms energy;
  bool operator==(const RibSet&) const = default;
};

}  // namespace spineloft::ribs
