#include "engine/ribs/d2.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/base/limits.h"

namespace spineloft::ribs {
namespace {

constexpr std::size_t kLanes = 4;
using Float4 = float __attribute__((vector_size(16)));

Float4 load(const float* from) {
  Float4 v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}
Float4 all(float v) { return Float4{v, v, v, v}; }
Float4 magnitude(Float4 v) { return v < all(0) ? -v : v; }

// atan(√w) / √w on [0, 1]: interpolated at Chebyshev nodes, relative error below 2e-7.
Float4 arctanOverArgument(Float4 w) {
  constexpr std::array<float, 8> c{0.999999882f,  -0.333318127f,  0.199669618f,  -0.140032902f,
                                   0.0986886546f, -0.0588297531f, 0.0237805186f, -0.00455979199f};
  Float4 sum = all(c[7]);
  for (std::size_t i = 7; i-- > 0;) sum = sum * w + all(c[i]);
  return sum;
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
  const Float4 x0 = all(static_cast<float>(x.x - points_[0].x));
  const Float4 y0 = all(static_cast<float>(x.y - points_[0].y));
  Float4 value = all(0), gradientX = all(0), gradientY = all(0);
  for (std::size_t i = 0; i < startX_.size(); i += kLanes) {
    const Float4 ax = load(&startX_[i]) - x0, ay = load(&startY_[i]) - y0;
    const Float4 ex = load(&alongX_[i]), ey = load(&alongY_[i]), reach = load(&reach_[i]);
    const Float4 u1 = ax * ex + ay * ey, u2 = u1 + reach, v = ex * ay - ey * ax;
    const Float4 v2 = v * v, f1 = 1 / (u1 * u1 + v2), f2 = 1 / (u2 * u2 + v2);
    const Float4 along = u1 * u2 + v2, size = magnitude(v), across = reach * size;
    const Float4 run = magnitude(along);
    const auto steep = across > run;
    const Float4 longer = steep ? across : run, shorter = steep ? run : across;
    const Float4 inverse = 1 / longer, z = shorter * inverse;
    const Float4 slope = arctanOverArgument(z * z);
    Float4 angle = z * slope;
    angle = steep ? all(std::numbers::pi_v<float> / 2) - angle : angle;
    angle = along < all(0) ? all(std::numbers::pi_v<float>) - angle : angle;
    // Seen under less than 45° from outside: θ/|v| without dividing by a v that may be 0.
    const auto slim = (across <= along);
    const Float4 term = slim ? reach * slope * inverse : angle / size;
    const auto inLine = (v2 < all(1e-4f) * (u1 * u2));
    const Float4 g1 = 1 / u1, g2 = 1 / u2;
    const Float4 series = all(2.f / 3) * v * (g1 * g1 * g1 - g2 * g2 * g2);
    const Float4 sideways = inLine ? series : (term + u2 * f2 - u1 * f1) / v;
    const Float4 lengthwise = f1 - f2;
    value += term;
    gradientX += lengthwise * ex - sideways * ey;
    gradientY += lengthwise * ey + sideways * ex;
  }
  return {value[0] + value[1] + value[2] + value[3],
          gradientX[0] + gradientX[1] + gradientX[2] + gradientX[3],
          gradientY[0] + gradientY[1] + gradientY[2] + gradientY[3]};
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
