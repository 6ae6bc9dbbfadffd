#include "engine/ribs/d2.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/base/lanes.h"
#include "engine/base/limits.h"

namespace spineloft::ribs {
namespace {

constexpr std::size_t kLanes = 4;

// atan(√w) / √w on [0, 1]: interpolated at Chebyshev nodes, relative error below 2e-7.
Float4 arctanOverArgument(Float4 w) {
  constexpr std::array<float, 8> c{0.999999882f,  -0.333318127f,  0.199669618f,  -0.140032902f,
                                   0.0986886546f, -0.0588297531f, 0.0237805186f, -0.00455979199f};
  Float4 sum = all4(c[7]);
  for (std::size_t i = 7; i-- > 0;) sum = sum * w + all4(c[i]);
  return sum;
}

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

struct Segments {
  const float *startX, *startY, *alongX, *alongY, *reach;
};

// Segments of one stretch, and how many of its own half extents away a stretch counts as far: the
// remaining error of its share is at most the fourth power of the inverse.
constexpr std::size_t kStretch = 4;
constexpr double kNearShare = 4;

// I and ∇I of four segments, as in segmentTerm.
inline void addSegments(const Lanes& at, const Segments& s, Sums& sums) {
  const Float4 ax = load4(s.startX) - at.x, ay = load4(s.startY) - at.y;
  const Float4 ex = load4(s.alongX), ey = load4(s.alongY), reach = load4(s.reach);
  const Float4 u1 = ax * ex + ay * ey, u2 = u1 + reach, v = ex * ay - ey * ax;
  const Float4 v2 = v * v, near = u1 * u1 + v2, far = u2 * u2 + v2;
  // One division for both; lengths whose fourth power is beyond single precision do not occur.
  const Float4 both = 1 / (near * far), f1 = far * both, f2 = near * both;
  const Float4 along = u1 * u2 + v2, size = magnitude4(v), across = reach * size;
  const Float4 run = magnitude4(along);
  const auto steep = across > run;
  const Float4 longer = steep ? across : run, shorter = steep ? run : across;
  const Float4 inverse = 1 / longer, away = 1 / v, z = shorter * inverse;
  const Float4 slope = arctanOverArgument(z * z);
  Float4 angle = z * slope;
  angle = steep ? all4(std::numbers::pi_v<float> / 2) - angle : angle;
  angle = along < all4(0) ? all4(std::numbers::pi_v<float>) - angle : angle;
  // Seen under less than 45° from outside: θ/|v| without dividing by a v that may be 0.
  const auto slim = (across <= along);
  const Float4 term = slim ? reach * slope * inverse : angle * magnitude4(away);
  const auto inLine = (v2 < all4(1e-4f) * (u1 * u2));
  // There 1/u² is as good as 1/(u² + v²).
  const Float4 series = all4(2.f / 3) * v * (u1 * f1 * f1 - u2 * f2 * f2);
  const Float4 sideways = inLine ? series : (term + u2 * f2 - u1 * f1) * away;
  const Float4 lengthwise = f1 - f2;
  sums.value += term;
  sums.gradientX += lengthwise * ex - sideways * ey;
  sums.gradientY += lengthwise * ey + sideways * ex;
}

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

D2Field::D2Field(std::span<const PicturePoint> polyline) { assign(polyline); }

void D2Field::assign(std::span<const PicturePoint> polyline) {
  points_.clear();
  for (const PicturePoint& p : polyline) {
    if (points_.empty() || spineloft::distance(points_.back(), p) > kSamePoint)
      points_.push_back(p);
  }
  const std::size_t segments = points_.empty() ? 0 : points_.size() - 1;
  const std::size_t padded = (segments + kLanes - 1) / kLanes * kLanes;
  for (auto* plane : {&startX_, &startY_, &alongX_, &alongY_, &reach_}) plane->assign(padded, 0);
  length_ = 0;
  for (std::size_t i = 0; i < padded; ++i) {
    // Lanes beyond the last segment see nothing: a length of 0, far from everything.
    startX_[i] = startY_[i] = 1e9f;
    alongX_[i] = 1;
    if (i >= segments) continue;
    const double length = spineloft::distance(points_[i], points_[i + 1]);
    const PicturePoint start = points_[i] - points_[0];
    const PicturePoint along = (points_[i + 1] - points_[i]) / length;
    startX_[i] = static_cast<float>(start.x);
    startY_[i] = static_cast<float>(start.y);
    alongX_[i] = static_cast<float>(along.x);
    alongY_[i] = static_cast<float>(along.y);
    reach_[i] = static_cast<float>(length);
    length_ += length;
  }
  gather(kStretch, stretches_);
  if (segments >= kGrouped) {
    gather(kStretch * kLanes, groups_);
  } else {
    groups_.mass.clear();
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
  for (std::size_t i = 0; i < startX_.size(); i += kLanes) {
    addSegments(at, {&startX_[i], &startY_[i], &alongX_[i], &alongY_[i], &reach_[i]}, sums);
  }
  return sums.total();
}

void D2Field::gather(std::size_t segments, Runs& runs) const {
  const std::size_t count = (startX_.size() + segments - 1) / segments;
  const std::size_t padded = (count + kLanes - 1) / kLanes * kLanes;
  for (auto* plane : {&runs.middleX, &runs.middleY, &runs.mass, &runs.momentXX, &runs.momentXY,
                      &runs.momentYY, &runs.near}) {
    plane->assign(padded, 0);
  }
  for (std::size_t g = 0; g < padded; ++g) {
    runs.middleX[g] = runs.middleY[g] = 1e9f;  // a lane without segments: far from everything, no mass
    const std::size_t first = g * segments, last = std::min(first + segments, startX_.size());
    double mass = 0, cx = 0, cy = 0;
    for (std::size_t i = first; i < last; ++i) {
      const auto t = static_cast<double>(reach_[i]);
      mass += t;
      cx += t * (static_cast<double>(startX_[i]) + 0.5 * t * static_cast<double>(alongX_[i]));
      cy += t * (static_cast<double>(startY_[i]) + 0.5 * t * static_cast<double>(alongY_[i]));
    }
    if (!(mass > 0)) continue;
    cx /= mass;
    cy /= mass;
    double xx = 0, xy = 0, yy = 0, extent = 0;
    for (std::size_t i = first; i < last; ++i) {
      const auto t = static_cast<double>(reach_[i]);
      if (!(t > 0)) continue;
      const auto ex = static_cast<double>(alongX_[i]), ey = static_cast<double>(alongY_[i]);
      const double mx = static_cast<double>(startX_[i]) + 0.5 * t * ex - cx;
      const double my = static_cast<double>(startY_[i]) + 0.5 * t * ey - cy;
      const double own = t * t * t / 12;
      xx += t * mx * mx + own * ex * ex;
      xy += t * mx * my + own * ex * ey;
      yy += t * my * my + own * ey * ey;
      extent = std::max(extent, std::hypot(mx, my) + 0.5 * t);
    }
    runs.middleX[g] = static_cast<float>(cx);
    runs.middleY[g] = static_cast<float>(cy);
    runs.mass[g] = static_cast<float>(mass);
    runs.momentXX[g] = static_cast<float>(xx);
    runs.momentXY[g] = static_cast<float>(xy);
    runs.momentYY[g] = static_cast<float>(yy);
    runs.near[g] = static_cast<float>(kNearShare * kNearShare * extent * extent);
  }
}

// I and ∇I of four runs that are far; calls `close` with the number of each of the others.
template <class Runs, class Close>
inline void addRuns(const Lanes& at, const Runs& runs, std::size_t g, Sums& sums, const Close& whenClose) {
  const Float4 dx = at.x - load4(&runs.middleX[g]), dy = at.y - load4(&runs.middleY[g]);
  const Float4 r2 = dx * dx + dy * dy, inverse = 1 / r2;
  const auto close = r2 < load4(&runs.near[g]);
  // f(d) = |d|⁻² to second order about the centroid: I = T f + ½ M : ∇∇f.
  const Float4 xx = load4(&runs.momentXX[g]), xy = load4(&runs.momentXY[g]), yy = load4(&runs.momentYY[g]);
  const Float4 mx = xx * dx + xy * dy, my = xy * dx + yy * dy;
  const Float4 q = mx * dx + my * dy, trace = xx + yy, mass = load4(&runs.mass[g]);
  const Float4 i2 = inverse * inverse, i3 = i2 * inverse;
  const Float4 value = mass * inverse - trace * i2 + 4 * q * i3;
  const Float4 radial = -2 * mass * i2 + 4 * trace * i3 - 24 * q * i3 * inverse;
  sums.value += close ? all4(0) : value;
  sums.gradientX += close ? all4(0) : radial * dx + 8 * mx * i3;
  sums.gradientY += close ? all4(0) : radial * dy + 8 * my * i3;
  for (std::size_t lane = 0; lane < kLanes && any4(close); ++lane) {
    if (close[lane]) whenClose(g + lane);
  }
}

// Segments of a stretch: `planes` begin with the first one of all, of which there are `count`.
inline void addStretch(const Lanes& at, const Segments& planes, std::size_t count, std::size_t stretch, Sums& sums) {
  const std::size_t first = stretch * kStretch, last = std::min(first + kStretch, count);
  for (std::size_t i = first; i < last; i += kLanes) {
    addSegments(at, {planes.startX + i, planes.startY + i, planes.alongX + i, planes.alongY + i, planes.reach + i}, sums);
  }
}

// Apart, so that the short polylines' sum stays in registers.
template <class Runs>
[[gnu::noinline]] Sums sumOfGroups(const Lanes& at, const Segments& planes, std::size_t count, const Runs& stretches,
                                   const Runs& groups) {
  Sums sums;
  const auto near = [&](std::size_t stretch) { addStretch(at, planes, count, stretch, sums); };
  const auto open = [&](std::size_t group) { addRuns(at, stretches, group * kLanes, sums, near); };
  for (std::size_t g = 0; g < groups.size(); g += kLanes) addRuns(at, groups, g, sums, open);
  return sums;
}

D2Integral D2Field::quickIntegral(PicturePoint x) const {
  const Lanes at(x, points_[0]);
  const Segments planes{startX_.data(), startY_.data(), alongX_.data(), alongY_.data(), reach_.data()};
  if (groups_.size() > 0) return sumOfGroups(at, planes, startX_.size(), stretches_, groups_).total();
  Sums sums;
  const auto near = [&](std::size_t stretch) { addStretch(at, planes, startX_.size(), stretch, sums); };
  for (std::size_t g = 0; g < stretches_.size(); g += kLanes) addRuns(at, stretches_, g, sums, near);
  return sums.total();
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
