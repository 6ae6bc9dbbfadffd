#include "engine/vision/thresholds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace spineloft::vision {
namespace {

/// Gradient sizes up to 32 Lab units a pixel in steps of 1/64; larger ones share the last bin.
constexpr std::size_t kBins = 2048;
constexpr double kBinsPerUnit = 64;
/// Smaller than this is no change at all: rounding in the tables of the Lab conversion.
constexpr double kNoChange = 1e-3;
constexpr double kQuietShare = 0.3, kRayleighOfQuietShare = 0.8446;  // sqrt(−2 ln 0.7)
constexpr double kClutterShare = 0.9;

using Histogram = std::array<std::size_t, kBins>;

double quantile(const Histogram& histogram, std::size_t total, double share) {
  const double wanted = share * static_cast<double>(total);
  double seen = 0;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    const double here = static_cast<double>(histogram[bin]);
    if (here > 0 && seen + here >= wanted) {
      return (static_cast<double>(bin) + (wanted - seen) / here) / kBinsPerUnit;
    }
    seen += here;
  }
  return 0;
}

}  // namespace

Thresholds chooseThresholds(std::span<const float> gradientX, std::span<const float> gradientY) {
  Histogram all{}, changing{};
  const std::size_t count = std::min(gradientX.size(), gradientY.size());
  for (std::size_t i = 0; i < count; ++i) {
    const double size = std::sqrt(static_cast<double>(gradientX[i]) * gradientX[i] +
                                  static_cast<double>(gradientY[i]) * gradientY[i]);
    const std::size_t bin =
        static_cast<std::size_t>(std::min(size * kBinsPerUnit, static_cast<double>(kBins - 1)));
    ++all[bin];
    if (size > kNoChange) ++changing[bin];
  }
  const std::size_t moving = std::accumulate(changing.begin(), changing.end(), std::size_t{0});
  // With most of the picture digitally flat, what changes is the drawing itself, not noise.
  const double noise =
      2 * moving > count ? quantile(changing, moving, kQuietShare) / kRayleighOfQuietShare : 0;
  const double clutter = quantile(all, count, kClutterShare);
  const double high = std::max(std::clamp(clutter, kFaintest, kStrongest), kNoiseFactor * noise);
  return {kLowShare * high, high, noise};
}

bool isContour(double sum, int count, double noise) {
  if (count < kShortestContour) return false;
  const double mean = sum / count;
  return noise <= 0 || (mean / noise - kNoiseLevel) * std::sqrt(count) >= kDoubt;
}

}  // namespace spineloft::vision
