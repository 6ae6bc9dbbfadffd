#include "engine/document/placement.h"

#include <algorithm>
#include <cmath>

namespace spineloft::document {
namespace {

constexpr double kUnitSlack = 1e-6;  // how far from 1 the length of a normal may be

bool isNear(WorldPoint p) {
  // Written so that NaN fails too.
  return std::abs(p.x) <= kMostMove && std::abs(p.y) <= kMostMove && std::abs(p.z) <= kMostMove;
}

}  // namespace

bool isValid(const Placement& placement) {
  return isNear(placement.pivot) && isNear(placement.move) && geometry::isValid(placement.turn) &&
         placement.scale >= kLeastScale && placement.scale <= kMostScale;
}

bool isValid(const MirrorPlane& plane) { return isNear(plane.point) && std::abs(norm(plane.normal) - 1) <= kUnitSlack; }

Placement moved(const Placement& placement, const Motion& motion) {
  Placement out = placement;
  // What the pivot does, everything does: the rest is turn and scale about it.
  out.move = motion(placement.pivot + placement.move) - placement.pivot;
  if (!motion.turn.isRest()) out.turn = geometry::after(placement.turn, motion.turn);
  out.scale = std::clamp(placement.scale * motion.scale, kLeastScale, kMostScale);
  return out;
}

Placement mirrored(const Placement& placement, const MirrorPlane& plane) {
  // A mirror is minus a half turn about its normal. So with N and X the half turns about the normal
  // and the x axis, and F = −X: mirror · R = (N R X) F, and mirror · R F = N R X.
  Placement out = placement;
  const geometry::Turn halfX{0, 1, 0, 0};
  const geometry::Turn halfN{0, plane.normal.x, plane.normal.y, plane.normal.z};
  out.turn = geometry::after(geometry::after(halfX, placement.turn), halfN);
  out.move = plane(placement.pivot + placement.move) - placement.pivot;
  out.mirrored = !placement.mirrored;
  return out;
}

Placement about(const Placement& placement, WorldPoint pivot) {
  if (pivot == placement.pivot) return placement;  // without rounding
  Placement out = placement;
  out.pivot = pivot;
  out.move = placement(pivot) - pivot;
  return out;
}

Motion between(const Placement& from, const Placement& to) {
  Motion motion;
  motion.centre = from.pivot + from.move;
  motion.turn = geometry::after(geometry::inverse(from.turn), to.turn);
  motion.scale = to.scale / from.scale;
  motion.move = to(from.pivot) - motion.centre;
  return motion;
}

MirrorPlane moved(const MirrorPlane& plane, const Motion& motion) {
  return {motion(plane.point), normalized(geometry::turned(motion.turn, plane.normal))};
}

}  // namespace spineloft::document
