#include "engine/image/lab.h"

#include <cmath>

#include "engine/image/srgb.h"

namespace spineloft::image {
namespace {

/// Where the cube root's curve of L*a*b* turns into a line.
constexpr double kBend = 6.0 / 29;

double curve(double t) { return t > kBend * kBend * kBend ? std::cbrt(t) : t / (3 * kBend * kBend) + 4.0 / 29; }

/// sRGB's decoding curve and the cube root of L*a*b*, tabulated: exact enough (1e-6 in f, so 1e-3
/// in L, a and b) and the same on every platform.
struct Tables {
  static constexpr int kRootBits = 13, kStepBits = 12;
  static constexpr int kOne = 1 << (kRootBits + kStepBits);
  /// A chord of the curve: start + rise · (how far into it, in 1/kOne).
  struct Chord {
    float start = 0, rise = 0;
  };
  /// X, Y and Z over those of the D65 white, in 1/kOne; the fourth is there for SIMD.
  using Xyz = std::array<std::int32_t, 4>;
  /// What each value of red, green and blue adds.
  std::array<std::array<Xyz, 256>, 3> light{};
  std::array<Chord, (1 << kRootBits) + 1> root{};

  Tables() {
    // Linear sRGB to XYZ over the D65 white, so that white is exactly (1, 1, 1).
    constexpr double kXyz[3][3] = {
        {0.433953, 0.376219, 0.189828}, {0.212671, 0.715160, 0.072169}, {0.017758, 0.109477, 0.872765}};
    for (std::size_t i = 0; i < 256; ++i) {
      const double linear = linearOfSrgb(static_cast<double>(i) / 255);
      for (std::size_t from = 0; from < 3; ++from) {
        for (std::size_t to = 0; to < 3; ++to) {
          light[from][i][to] = static_cast<std::int32_t>(std::lround(kOne * linear * kXyz[to][from]));
        }
      }
    }
    for (std::size_t i = 0; i < root.size(); ++i) {
      const double step = 1.0 / (1 << kRootBits), low = static_cast<double>(i) * step;
      root[i] = {static_cast<float>(curve(low)),
                 static_cast<float>((curve(low + step) - curve(low)) / (1 << kStepBits))};
    }
  }
  /// f(t) of L*a*b*, t in 1/kOne.
  float f(std::int32_t t) const {
    const Chord& chord = root[static_cast<std::size_t>(t >> kStepBits)];
    return chord.start + chord.rise * static_cast<float>(t & ((1 << kStepBits) - 1));
  }
  std::array<float, 3> lab(std::uint8_t red, std::uint8_t green, std::uint8_t blue) const {
    const Xyz &r = light[0][red], &g = light[1][green], &b = light[2][blue];
    Xyz sum;
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = r[i] + g[i] + b[i];
    const float x = f(sum[0]), y = f(sum[1]), z = f(sum[2]);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
  }
};

const Tables& tables() {
  static const Tables kTables;
  return kTables;
}

}  // namespace

std::array<float, 3> labOf(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
  return tables().lab(red, green, blue);
}

void labRow(std::span<const std::uint8_t> pixels, const LabPlanes& out) {
  const Tables& table = tables();
  float* __restrict l = out.l, * __restrict a = out.a, * __restrict b = out.b;
  const std::size_t count = pixels.size() / 4;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t* pixel = pixels.data() + 4 * i;
    std::uint8_t red = pixel[0], green = pixel[1], blue = pixel[2];
    if (const int alpha = pixel[3]; alpha < 255) {
      const auto onPaper = [alpha](int value) {
        return static_cast<std::uint8_t>((value * alpha + 255 * (255 - alpha) + 127) / 255);
      };
      red = onPaper(red), green = onPaper(green), blue = onPaper(blue);
    }
    const auto lab = table.lab(red, green, blue);
    l[i] = lab[0], a[i] = lab[1], b[i] = lab[2];
  }
}

}  // namespace spineloft::image
