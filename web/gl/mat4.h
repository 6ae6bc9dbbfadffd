// Just enough linear algebra for a camera: column-major 4 × 4 matrices as WebGL wants them.
#pragma once

#include <array>
#include <cmath>

#include "engine/base/vec.h"

namespace spineloft::gl {

struct Mat4 {
  /// m[4 * column + row]
  std::array<float, 16> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  bool operator==(const Mat4&) const = default;
};

inline Mat4 operator*(const Mat4& a, const Mat4& b) {
  Mat4 out;
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t r = 0; r < 4; ++r) {
      float sum = 0;
      for (std::size_t k = 0; k < 4; ++k) sum += a.m[4 * k + r] * b.m[4 * c + k];
      out.m[4 * c + r] = sum;
    }
  }
  return out;
}

/// Uniform scale, then shift.
inline Mat4 scaleThenShift(double scale, double x, double y, double z) {
  Mat4 out;
  out.m[0] = out.m[5] = out.m[10] = static_cast<float>(scale);
  out.m[12] = static_cast<float>(x);
  out.m[13] = static_cast<float>(y);
  out.m[14] = static_cast<float>(z);
  return out;
}

/// World → eye: `right`, `up`, `back` orthonormal, the eye looks along −back.
inline Mat4 viewMatrix(WorldPoint eye, WorldPoint right, WorldPoint up, WorldPoint back) {
  const auto f = [](double v) { return static_cast<float>(v); };
  return {{f(right.x), f(up.x), f(back.x), 0, f(right.y), f(up.y), f(back.y), 0, f(right.z), f(up.z), f(back.z), 0,
           f(-dot(right, eye)), f(-dot(up, eye)), f(-dot(back, eye)), 1}};
}

/// Eye → clip; `halfHeight` is the tangent of half the vertical field of view.
inline Mat4 perspective(double halfHeight, double aspect, double near, double far) {
  Mat4 out;
  out.m.fill(0);
  out.m[0] = static_cast<float>(1 / (halfHeight * aspect));
  out.m[5] = static_cast<float>(1 / halfHeight);
  out.m[10] = static_cast<float>((far + near) / (near - far));
  out.m[11] = -1;
  out.m[14] = static_cast<float>(2 * far * near / (near - far));
  return out;
}

/// A box in world coordinates → clip, without perspective (the shadow's camera, from above).
inline Mat4 fromAbove(WorldPoint centre, double radius, double low, double high) {
  Mat4 out;
  out.m.fill(0);
  const double depth = high - low;
  out.m[0] = static_cast<float>(1 / radius);  // x → x
  out.m[9] = static_cast<float>(1 / radius);  // z → y
  out.m[6] = static_cast<float>(2 / depth);   // y → z
  out.m[12] = static_cast<float>(-centre.x / radius);
  out.m[13] = static_cast<float>(-centre.z / radius);
  out.m[14] = static_cast<float>(-(high + low) / depth);
  out.m[15] = 1;
  return out;
}

}  // namespace spineloft::gl
