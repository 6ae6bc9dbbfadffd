// Which curves of a stack go on as which, and how they turn on the way. Internal to stack/.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "engine/stack/sheets.h"

namespace spineloft::stack {

inline constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// A curve on its sheet.
struct Drawn {
  std::size_t sheet = 0, piece = 0;
  bool hole = false;
  std::size_t outer = 0;                    ///< of a hole the curve round it, else the curve itself
  int depth = 0;                            ///< of how many rings the outer one lies in the hole
  SectionPoint centre;                      ///< of the area of the outer one, plane coordinates
  double radius = 0;                        ///< of the circle of equal area
  std::size_t up = kNone, down = kNone;     ///< the one curve that it becomes, and the one that it was
  bool forksUp = false, forksDown = false;  ///< it is in a fork to that side
  std::vector<SectionPoint> ring;  ///< its points, as many as on `up` and `down`; plane coordinates, counter-clockwise
};

/// What is between two outer curves, of which one becomes the other.
struct Link {
  std::size_t from = 0, to = 0;
  double length = 0;   ///< along the rail, else between the centres, > 0
  double carried = 0;  ///< angle from x of the first sheet, carried to the second without turning, to x of that
  double turn = 0;     ///< best rotation from the first curve, carried, to the second, −π…π
  /// Where a point of the second curve about its centre belongs on the first sheet: turned by −this.
  double total() const { return turn - carried; }
};

/// Curves of two sheets that hang together and are not one and one: several become one, one several, or several several
/// others; or a hole goes on in one of several curves.
struct Fork {
  std::vector<std::array<std::size_t, 2>> links;  ///< ≥ 1: from the first sheet to the second
};

struct Network {
  std::vector<Drawn> curves;
  std::vector<Link> links;
  std::vector<Fork> forks;
  /// The link that leaves or reaches an outer curve, or null.
  const Link* above(std::size_t curve) const;
  const Link* below(std::size_t curve) const;
};

/// A direction or place relative to what carries it: in the rail's frame at the sheet, else in ModelSpace.
struct Carried {
  ModelPoint centre;  ///< of a curve
  ModelPoint x, y, normal;
};
Carried carriedBy(const Sheets& sheets, const Sheet& sheet, SectionPoint centre);

/// `v` turned as little as takes the unit vector `from` to the unit vector `to`, which is not −from.
ModelPoint leastTurned(ModelPoint v, ModelPoint from, ModelPoint to);

inline SectionPoint rotated(SectionPoint p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * p.x - s * p.y, s * p.x + c * p.y};
}

/// Which curves of neighbouring sheets belong together: those of which a fifth of the smaller lies in the other, most
/// first; a curve that overlaps none goes with the nearest. One becomes one or several, or several become one; several
/// become several others only where the sheet's links say so. Holes likewise, within curves that belong together. With
/// `sides` points on each.
Network linkSheets(const Sheets& sheets, int sides);

}  // namespace spineloft::stack
