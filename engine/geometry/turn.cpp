#include "engine/geometry/turn.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spineloft::geometry {
namespace {

constexpr double kUnitSlack = 1e-6;        // how far from 1 the length may be
constexpr double kStraightOn = 1e-9;       // sine of a turn that is none
constexpr double kStraightUp = 1 - 1e-12;  // sine of a tip beyond which turn and roll are one

/// The product p q of quaternions.
Turn product(const Turn& p, const Turn& q) {
  return {p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z, p.w * q.x + p.x * q.w + p.y * q.z - p.z * q.y,
          p.w * q.y - p.x * q.z + p.y * q.w + p.z * q.x, p.w * q.z + p.x * q.y - p.y * q.x + p.z * q.w};
}

double lengthOf(const Turn& q) { return std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z); }

}  // namespace

bool isValid(const Turn& turn) {
  // Written so that NaN fails too.
  return std::abs(lengthOf(turn) - 1) <= kUnitSlack;
}

Turn normalized(const Turn& turn) {
  const double length = lengthOf(turn);
  if (!(length > 0) || !std::isfinite(length)) return {};
  const double scale = (turn.w < 0 ? -1 : 1) / length;
  return {turn.w * scale, turn.x * scale, turn.y * scale, turn.z * scale};
}

template <class Space>
Turn turnAbout(Vec3<Space> axis, double angle) {
  const Vec3<Space> unit = spineloft::normalized(axis) * std::sin(angle / 2);
  return normalized({std::cos(angle / 2), unit.x, unit.y, unit.z});
}
template Turn turnAbout(Vec3<WorldSpace>, double);
template Turn turnAbout(Vec3<ModelSpace>, double);

template <class Space>
Turn turnTo(Vec3<Space> from, Vec3<Space> to) {
  const Vec3<Space> a = spineloft::normalized(from), b = spineloft::normalized(to), axis = cross(a, b);
  const double cosine = dot(a, b);
  if (norm(axis) > kStraightOn) return normalized({1 + cosine, axis.x, axis.y, axis.z});
  if (cosine > 0) return {};
  return turnAbout(cross(a, std::abs(a.x) < std::abs(a.z) ? Vec3<Space>{1, 0, 0} : Vec3<Space>{0, 0, 1}),
                   std::numbers::pi);
}
template Turn turnTo(Vec3<WorldSpace>, Vec3<WorldSpace>);
template Turn turnTo(Vec3<ModelSpace>, Vec3<ModelSpace>);

Turn after(const Turn& first, const Turn& then) { return normalized(product(then, first)); }

Turn inverse(const Turn& turn) { return {turn.w, -turn.x, -turn.y, -turn.z}; }

Angles anglesOf(const Turn& q) {
  // The matrix is Y(turn) X(tip) Z(roll); its third column is (cos tip sin turn, −sin tip,
  // cos tip cos turn), its second row (cos tip sin roll, cos tip cos roll, −sin tip).
  const double sine = std::clamp(2 * (q.w * q.x - q.y * q.z), -1.0, 1.0);
  if (std::abs(sine) >= kStraightUp) {
    const double turn = std::atan2(2 * (q.w * q.y - q.x * q.z), 1 - 2 * (q.y * q.y + q.z * q.z));
    return {std::copysign(std::numbers::pi / 2, sine), turn, 0};
  }
  return {std::asin(sine), std::atan2(2 * (q.x * q.z + q.w * q.y), 1 - 2 * (q.x * q.x + q.y * q.y)),
          std::atan2(2 * (q.x * q.y + q.w * q.z), 1 - 2 * (q.x * q.x + q.z * q.z))};
}

Turn turnOf(const Angles& angles) {
  using P = WorldPoint;
  const Turn rolled = turnAbout(P{0, 0, 1}, angles.roll);
  return after(after(rolled, turnAbout(P{1, 0, 0}, angles.tip)), turnAbout(P{0, 1, 0}, angles.turn));
}

}  // namespace spineloft::geometry
