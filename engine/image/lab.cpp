#include "engine/image/lab.h"

#include <algorithm>
#include <cmath>

namespace spineloft::image {
namespace {

/// sRGB's decoding curve and the cube root of L*a*b*, tabulated: exact enough (1e-5 in L, a and b)
/// and the same on every platform.
struct Tables {
  static constexpr int kRootSteps = 8192;
  std::array<float, 256> linear{};
  std::array<float, kRootSteps + 2> root{};

  Tables() {
    for (std::size_t i = 0; i < linear.size(); ++i) {
      const double v = static_cast<double>(i) / 255;
      linear[i] = static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
    }
    for (std::size_t i = 0; i < root.size(); ++i) {
      const double t = static_cast<double>(i) / kRootSteps, bend = 6.0 / 29;
      root[i] = static_cast<float>(t > bend * bend * bend ? std::cbrt(t)
                                                          : t / (3 * bend * bend) + 4.0 / 29);
    }
  }
  /// f(t) of L*a*b*, t in [0, 1].
  float f(float t) const {
    const float at = std::clamp(t, 0.0f, 1.0f) * kRootSteps;
    const std::size_t i = static_cast<std::size_t>(at);
    return root[i] + (at - static_cast<float>(i)) * (root[i + 1] - root[i]);
  }
};

const Tables& tables() {
  static const Tables kTables;
  return kTables;
}

void writeLab(const Tables& table, const std::array<std::uint8_t, 3>& rgb, float* lab) {
  const float r = table.linear[rgb[0]], g = table.linear[rgb[1]], b = table.linear[rgb[2]];
  // Linear sRGB to XYZ over the D65 white, so that white is exactly (1, 1, 1).
  const float x = table.f(0.433953f * r + 0.376219f * g + 0.189828f * b);
  const float y = table.f(0.212671f * r + 0.715160f * g + 0.072169f * b);
  const float z = table.f(0.017758f * r + 0.109477f * g + 0.872765f * b);
  lab[0] = 116 * y - 16;
  lab[1] = 500 * (x - y);
  lab[2] = 200 * (y - z);
}

}  // namespace

std::array<float, 3> labOf(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
  std::array<float, 3> lab{};
  writeLab(tables(), {red, green, blue}, lab.data());
  return lab;
}

std::vector<float> labPixels(ImageView image) {
  const Tables& table = tables();
  const std::size_t count = image.pixels.size() / 4;
  std::vector<float> lab(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t* pixel = image.pixels.data() + 4 * i;
    const int alpha = pixel[3];
    const auto onPaper = [alpha](int value) {
      return static_cast<std::uint8_t>((value * alpha + 255 * (255 - alpha) + 127) / 255);
    };
    writeLab(table, {onPaper(pixel[0]), onPaper(pixel[1]), onPaper(pixel[2])}, lab.data() + 3 * i);
  }
  return lab;
}

}  // namespace spineloft::image
