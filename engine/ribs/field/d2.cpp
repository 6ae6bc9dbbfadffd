#include "engine/ribs/field/d2.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/base/lanes.h"
#include "engine/base/limits.h"

namespace spineloft::ribs {
namespace {

constexpr std::size_t kLanes = 4;

// A point relative to the field's origin, in every lane.
struct Lanes {
  Float4 x, y;
  Lanes(PicturePoint p, PicturePoint origin)
      : x(all4(static_cast<float>(p.x - origin.x))), y(all4(static_cast<float>(p.y - origin.y))) {}
};

struct Sums {
  Float4 value = all4(0), gradientX = all4(0), gradientY = all4(0);
  D2Integral total() const {
    const auto sum = [](Float4 v) { return v[0] + v[1] + v[2] + v[3]; };
    return {sum(value), sum(gradientX), sum(gradientY)};
  }
};

// How many of its own half extents away a stretch counts as far: the remaining error of its share is at most
// the fourth power of the inverse.
constexpr double kNearShare = 4;

struct Term {
  double value = 0;
  PicturePoint gradient;
};

// I and ∇I of the segment from p along the unit vector e for length T, seen from x. In the frame of
// the segment (u along, v across) I = ∫ du / (u² + v²) = θ / |v|, θ = atan2(T|v|, u₁u₂ + v²) the
// angle under which the segment is seen; ∂I/∂u = 1/|a|² − 1/|b|² and ∂I/∂v = (I + [u/(u²+v²)]) / v.
Term segmentTerm(PicturePoint x, PicturePoint p, PicturePoint e, double length) {
  const PicturePoint a = p - x;
  const double u1 = dot(a, e), u2 = u1 + length, v = cross(e, a);
  const double near = u1 * u1 + v * v, far = u2 * u2 + v * v;
  const double along = u1 * u2 + v * v, across = length * std::abs(v);
  const double f1 = 1 / near, f2 = 1 / far;
  double value = 0, sideways = 0;
  if (v * v < 1e-8 * along && u1 * u2 > 0) {
    // On the segment's own line, outside it: series of atan(c/d)/c, and of ∂I/∂v = 2v ∫ du / u⁴.
    const double z = across / along;
    value = length / along * (1 - z * z / 3);
    sideways = 2 * v * (1 / (u1 * u1 * u1) - 1 / (u2 * u2 * u2)) / 3;
  } else {
    value = std::atan2(across, along) / std::abs(v);
    sideways = (value + u2 * f2 - u1 * f1) / v;
  }
  const double lengthwise = f1 - f2;
  return {value, {lengthwise * e.x - sideways * e.y, lengthwise * e.y + sideways * e.x}};
}

}  // namespace

// The sums over four lanes. Segments and runs stand in blocks of four, for a register has to hold one address.
struct D2Field::Kernel {
  static Float4 load(const Lane4& lanes) { return load4(lanes.data()); }

  // I and ∇I of four segments, as in segmentTerm.
  static void addSegments(const Lanes& at, const Segments& s, Sums& sums) {
    const Float4 ax = load(s.startX) - at.x, ay = load(s.startY) - at.y;
    const Float4 ex = load(s.alongX), ey = load(s.alongY), reach = load(s.reach);
    const Float4 u1 = ax * ex + ay * ey, u2 = u1 + reach, v = ex * ay - ey * ax;
    const Float4 v2 = v * v, near = u1 * u1 + v2, far = u2 * u2 + v2;
    // One division for both; lengths whose fourth power is beyond single precision do not occur.
    const Float4 both = 1 / (near * far), f1 = far * both, f2 = near * both;
    const Float4 along = u1 * u2 + v2, across = reach * magnitude4(v), run = magnitude4(along);
    const auto steep = across > run;
    const Float4 longer = most4(across, run), shorter = least4(run, across);
    const Float4 inverse = 1 / longer, away = 1 / v, z = shorter * inverse;
    const Float4 slope = arctanOverArgument(z * z);
    Float4 angle = z * slope;
    angle = steep ? all4(std::numbers::pi_v<float> / 2) - angle : angle;
    angle = along < all4(0) ? all4(std::numbers::pi_v<float>) - angle : angle;
    // Seen under less than 45° from outside: θ/|v| without dividing by a v that may be 0.
    const auto slim = (across <= along);
    const Float4 term = slim ? reach * slope * inverse : angle * magnitude4(away);
    Float4 sideways = (term + u2 * f2 - u1 * f1) * away;
    const auto inLine = (v2 < all4(1e-4f) * (u1 * u2));
    if (any4(inLine)) {
      // There 1/u² is as good as 1/(u² + v²).
      const Float4 series = all4(2.f / 3) * v * (u1 * f1 * f1 - u2 * f2 * f2);
      sideways = inLine ? series : sideways;
    }
    const Float4 lengthwise = f1 - f2;
    sums.value += term;
    sums.gradientX += lengthwise * ex - sideways * ey;
    sums.gradientY += lengthwise * ey + sideways * ex;
  }

  // I and ∇I of four runs that are far; calls `close` with the lane of each of the others.
  template <class Close>
  static void addRuns(const Lanes& at, const Runs& runs, Sums& sums, const Close& whenClose) {
    const Float4 dx = at.x - load(runs.middleX), dy = at.y - load(runs.middleY);
    const Float4 r2 = dx * dx + dy * dy, inverse = 1 / r2;
    const auto close = r2 < load(runs.near);
    // f(d) = |d|⁻² to second order about the centroid: I = T f + ½ M : ∇∇f. Moments are held eightfold: factors
    // that are powers of two change no digit.
    const Float4 xx = load(runs.momentXX), xy = load(runs.momentXY), yy = load(runs.momentYY);
    const Float4 mx = xx * dx + xy * dy, my = xy * dx + yy * dy;
    const Float4 q = mx * dx + my * dy, mass = load(runs.mass);
    const Float4 i2 = inverse * inverse, i3 = i2 * inverse;
    Float4 value = mass * inverse - load(runs.trace) * i2 + all4(0.5f) * q * i3;
    const Float4 radial = load(runs.massTwice) * i2 - load(runs.traceFour) * i3 + all4(3) * q * i3 * inverse;
    Float4 gradientX = mx * i3 - radial * dx, gradientY = my * i3 - radial * dy;
    unsigned left = lanes4(close);
    if (left != 0) {
      value = close ? all4(0) : value;
      gradientX = close ? all4(0) : gradientX;
      gradientY = close ? all4(0) : gradientY;
    }
    sums.value += value;
    sums.gradientX += gradientX;
    sums.gradientY += gradientY;
    for (; left != 0; left &= left - 1) whenClose(static_cast<std::size_t>(std::countr_zero(left)));
  }

  // Runs of segments, four blocks of which `segments` begins with.
  static void addStretches(const Lanes& at, const Runs& stretches, const Segments* segments, Sums& sums) {
    addRuns(at, stretches, sums, [&](std::size_t lane) { addSegments(at, segments[lane], sums); });
  }

  // Apart, so that the short polylines' sum stays in registers.
  [[gnu::noinline]] static Sums ofGroups(const Lanes& at, const D2Field& field) {
    Sums sums;
    for (std::size_t g = 0; g < field.groups_.size(); ++g) {
      addRuns(at, field.groups_[g], sums, [&](std::size_t lane) {
        const std::size_t group = g * kLanes + lane;
        addStretches(at, field.stretches_[group], &field.segments_[group * kLanes], sums);
      });
    }
    return sums;
  }
  static Sums ofStretches(const Lanes& at, const D2Field& field) {
    Sums sums;
    for (std::size_t g = 0; g < field.stretches_.size(); ++g)
      addStretches(at, field.stretches_[g], &field.segments_[g * kLanes], sums);
    return sums;
  }
};

D2Field::D2Field(std::span<const PicturePoint> polyline) { assign(polyline); }

void D2Field::assign(std::span<const PicturePoint> polyline) {
  points_.clear();
  for (const PicturePoint& p : polyline) {
    if (points_.empty() || spineloft::distance(points_.back(), p) > kSamePoint) points_.push_back(p);
  }
  const std::size_t segments = points_.empty() ? 0 : points_.size() - 1;
  // Lanes beyond the last segment see nothing: a length of 0, far from everything.
  constexpr Lane4 kFar{1e9f, 1e9f, 1e9f, 1e9f}, kNone{};
  segments_.assign((segments + kLanes - 1) / kLanes, {kFar, kFar, {1, 1, 1, 1}, kNone, kNone});
  length_ = 0;
  for (std::size_t i = 0; i < segments; ++i) {
    const double length = spineloft::distance(points_[i], points_[i + 1]);
    const PicturePoint start = points_[i] - points_[0];
    const PicturePoint along = (points_[i + 1] - points_[i]) / length;
    Segments& block = segments_[i / kLanes];
    const std::size_t lane = i % kLanes;
    block.startX[lane] = static_cast<float>(start.x);
    block.startY[lane] = static_cast<float>(start.y);
    block.alongX[lane] = static_cast<float>(along.x);
    block.alongY[lane] = static_cast<float>(along.y);
    block.reach[lane] = static_cast<float>(length);
    length_ += length;
  }
  gather(1, stretches_);
  if (segments >= kGrouped) {
    gather(kLanes, groups_);
  } else {
    groups_.clear();
  }
}

D2Sample D2Field::sample(PicturePoint x) const {
  Term sum;
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
    const double length = spineloft::distance(points_[i], points_[i + 1]);
    const Term term = segmentTerm(x, points_[i], (points_[i + 1] - points_[i]) / length, length);
    sum.value += term.value;
    sum.gradient += term.gradient;
  }
  if (!(sum.value < std::numeric_limits<double>::infinity())) return {};
  const double d2 = std::sqrt(length_ / sum.value);
  // ∇d2 = −½ √A (ΣI)^(−3/2) Σ∇I
  return {d2, sum.gradient * (-0.5 * d2 / sum.value)};
}

double D2Field::distance(PicturePoint x) const { return sample(x).d2; }

D2Integral D2Field::integral(PicturePoint x) const {
  const Lanes at(x, points_[0]);
  Sums sums;
  for (const Segments& block : segments_) Kernel::addSegments(at, block, sums);
  return sums.total();
}

void D2Field::gather(std::size_t blocks, std::vector<Runs>& runs) const {
  const std::size_t count = (segments_.size() + blocks - 1) / blocks;
  // A lane without segments: far from everything, no mass.
  constexpr Lane4 kFar{1e9f, 1e9f, 1e9f, 1e9f}, kNone{};
  runs.assign((count + kLanes - 1) / kLanes, {kFar, kFar, kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone});
  for (std::size_t g = 0; g < count; ++g) {
    const std::size_t first = g * blocks, last = std::min(first + blocks, segments_.size());
    const auto forEach = [&](auto&& what) {
      for (std::size_t b = first; b < last; ++b) {
        const Segments& s = segments_[b];
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
          const auto t = static_cast<double>(s.reach[lane]);
          if (!(t > 0)) continue;
          const PicturePoint along{static_cast<double>(s.alongX[lane]), static_cast<double>(s.alongY[lane])};
          const PicturePoint start{static_cast<double>(s.startX[lane]), static_cast<double>(s.startY[lane])};
          what(t, along, start + along * (0.5 * t));
        }
      }
    };
    double mass = 0;
    PicturePoint centre;
    forEach([&](double t, PicturePoint, PicturePoint middle) {
      mass += t;
      centre += middle * t;
    });
    if (!(mass > 0)) continue;
    centre = centre / mass;
    double xx = 0, xy = 0, yy = 0, extent = 0;
    forEach([&](double t, PicturePoint e, PicturePoint middle) {
      const PicturePoint m = middle - centre;
      const double own = t * t * t / 12;
      xx += t * m.x * m.x + own * e.x * e.x;
      xy += t * m.x * m.y + own * e.x * e.y;
      yy += t * m.y * m.y + own * e.y * e.y;
      extent = std::max(extent, std::hypot(m.x, m.y) + 0.5 * t);
    });
    Runs& block = runs[g / kLanes];
    const std::size_t lane = g % kLanes;
    block.middleX[lane] = static_cast<float>(centre.x);
    block.middleY[lane] = static_cast<float>(centre.y);
    block.mass[lane] = static_cast<float>(mass);
    const auto ownXX = static_cast<float>(xx), ownXY = static_cast<float>(xy), ownYY = static_cast<float>(yy);
    const float trace = ownXX + ownYY;
    block.massTwice[lane] = 2 * block.mass[lane];
    block.momentXX[lane] = 8 * ownXX;
    block.momentXY[lane] = 8 * ownXY;
    block.momentYY[lane] = 8 * ownYY;
    block.trace[lane] = trace;
    block.traceFour[lane] = 4 * trace;
    block.near[lane] = static_cast<float>(kNearShare * kNearShare * extent * extent);
  }
}

D2Integral D2Field::quickIntegral(PicturePoint x) const {
  const Lanes at(x, points_[0]);
  return (groups_.empty() ? Kernel::ofStretches(at, *this) : Kernel::ofGroups(at, *this)).total();
}

double d2OfRadius(double radius, double length) {
  return std::sqrt(length * radius / (2 * std::atan(length / (2 * radius))));
}

double radiusOfD2(double d2, double length) {
  // ρ(d2) is between the near law π d2² / A and the far law d2, increasing and smooth: Newton on
  // ρ / (2 atan(A/2ρ)) = d2² / A from there converges in a few steps.
  const double target = d2 * d2 / length;
  double radius = std::min(std::numbers::pi * target, d2);
  for (int i = 0; i < 12; ++i) {
    const double q = length / (2 * radius), angle = std::atan(q);
    const double value = radius / (2 * angle);
    const double slope = 1 / (2 * angle) + q / (2 * angle * angle * (1 + q * q));
    const double step = (target - value) / slope;
    radius = std::max(radius + step, radius * 0.1);
    if (std::abs(step) < 1e-12 * radius) break;
  }
  return radius;
}

}  // namespace spineloft::ribs
