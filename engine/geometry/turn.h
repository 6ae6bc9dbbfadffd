// Turns in space as unit quaternions (Hamilton's, w first): v ↦ q v q⁻¹.
#pragma once

#include <array>

#include "engine/base/vec.h"

namespace spineloft::geometry {

/// A turn about an axis through the origin; the default turns nothing. q and −q are one turn: the
/// functions below return the one with w ≥ 0.
struct Turn {
  double w = 1, x = 0, y = 0, z = 0;
  bool operator==(const Turn&) const = default;
  bool isRest() const { return *this == Turn{}; }
};

/// Finite and of length 1 within 1e-6.
bool isValid(const Turn& turn);

/// Of length 1 and with w ≥ 0; nothing for a quaternion that is 0 or not finite.
Turn normalized(const Turn& turn);

/// By `angle` radians about `axis` (any length but 0), counter-clockwise seen from its tip.
template <class Space>
Turn turnAbout(Vec3<Space> axis, double angle);

/// The least turn after which `from` points where `to` does (any lengths but 0); of opposite ones about some axis
/// across.
template <class Space>
Turn turnTo(Vec3<Space> from, Vec3<Space> to);

/// First `first`, then `then`.
Turn after(const Turn& first, const Turn& then);

/// The way back.
Turn inverse(const Turn& turn);

template <class Space>
Vec3<Space> turned(const Turn& turn, Vec3<Space> v) {
  const Vec3<Space> q{turn.x, turn.y, turn.z};
  const Vec3<Space> t = cross(q, v) * 2.0;
  return v + t * turn.w + cross(q, t);
}

/// Angles in radians about x (tip), y (turn) and z (roll), applied in the order z, x, y: −π…π,
/// tip −π/2…π/2. At a tip of ±π/2, where turn and roll mean the same, the roll is 0.
struct Angles {
  double tip = 0, turn = 0, roll = 0;
  bool operator==(const Angles&) const = default;
};
Angles anglesOf(const Turn& turn);
Turn turnOf(const Angles& angles);

}  // namespace spineloft::geometry
