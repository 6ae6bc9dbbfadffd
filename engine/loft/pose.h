// Where a part stands: on the stroke it was traced on, on another line, and out of the picture's
// plane (SpineLoft 4, "reposing"; method: "Editing", "Loft").
#pragma once

#include <vector>

#include "engine/base/vec.h"
#include "engine/geometry/along.h"

namespace spineloft::loft {

/// The default stands where it was drawn, flat. All of it is authored.
struct Pose {
  /// The line on which the ribs stand instead of the traced one, scaled by the ratio of the lengths;
  /// empty: where they were traced. Picture pixels; may leave the picture.
  std::vector<PicturePoint> stroke;
  /// How far the spine comes towards the viewer, picture pixels; without points 0.
  geometry::AlongCurve depth;
  /// The spine winds round its line: full turns (negative: the other way round), and how far from
  /// the line, picture pixels. 0 turns: no coil.
  double coilTurns = 0, coilRadius = 0;
  /// The two ends are joined into a ring.
  bool closed = false;
  bool operator==(const Pose&) const = default;
  bool isRest() const { return *this == Pose{}; }
};

inline constexpr double kMostDepth = 1e5;  ///< picture pixels
inline constexpr double kMostCoilTurns = 20;
inline constexpr double kMostCoilRadius = 1e5;  ///< picture pixels

/// Finite and in range (the stroke: 0 or ≥ 2 points, at most kMostStrokePoints).
bool isValid(const Pose& pose);
inline constexpr std::size_t kMostStrokePoints = 20000;

}  // namespace spineloft::loft
