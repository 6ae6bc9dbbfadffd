// Where a part stands in the world: turned, scaled, moved, mirrored. Authored values and the few
// operations on them; everything that is shown, picked or written goes through pipeline/world.h.
#pragma once

#include <optional>

#include "engine/base/vec.h"
#include "engine/geometry/turn.h"

namespace spineloft::document {

/// From where a part was traced (WorldSpace) to where it stands (WorldSpace):
/// p ↦ pivot + move + turn(scale · F(p − pivot)), where F mirrors x when `mirrored`. The default
/// leaves the part where it was traced.
struct Placement {
  WorldPoint pivot;  ///< about which it turns and grows
  WorldPoint move;
  geometry::Turn turn;
  double scale = 1;
  bool mirrored = false;
  bool operator==(const Placement&) const = default;

  /// It stands where it was traced, whatever the pivot.
  bool isRest() const { return move == WorldPoint{} && turn.isRest() && scale == 1 && !mirrored; }
  WorldPoint operator()(WorldPoint p) const {
    const WorldPoint from = (p - pivot) * scale;
    return pivot + move + geometry::turned(turn, mirrored ? WorldPoint{-from.x, from.y, from.z} : from);
  }
};

/// A plane in WorldSpace; `normal` is a unit vector.
struct MirrorPlane {
  WorldPoint point;
  WorldPoint normal{1, 0, 0};
  bool operator==(const MirrorPlane&) const = default;

  WorldPoint operator()(WorldPoint p) const { return p - normal * (2 * dot(normal, p - point)); }
};

/// What a gesture does to all it holds: p ↦ centre + move + turn(scale · (p − centre)).
struct Motion {
  WorldPoint centre;
  WorldPoint move;
  geometry::Turn turn;
  double scale = 1;
  WorldPoint operator()(WorldPoint p) const { return centre + move + geometry::turned(turn, (p - centre) * scale); }
};

/// The longer side of a picture is 1: this is far and large enough for every model.
inline constexpr double kMostMove = 1000, kLeastScale = 0.001, kMostScale = 1000;

/// Finite and in range.
bool isValid(const Placement& placement);
bool isValid(const MirrorPlane& plane);

/// The motion after the placement; its pivot stays. The scale is kept in range.
Placement moved(const Placement& placement, const Motion& motion);
/// The mirror after the placement. Twice over one plane is the placement again.
Placement mirrored(const Placement& placement, const MirrorPlane& plane);
/// The same map about another pivot.
Placement about(const Placement& placement, WorldPoint pivot);
/// The motion that takes one placement to the other, about where the first has its pivot. The two
/// must both be mirrored, or neither.
Motion between(const Placement& from, const Placement& to);
/// The plane taken along by a motion.
MirrorPlane moved(const MirrorPlane& plane, const Motion& motion);

}  // namespace spineloft::document
