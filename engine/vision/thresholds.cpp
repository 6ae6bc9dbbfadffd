#include "engine/vision/thresholds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace spineloft::vision {
namespace {

/// Gradient sizes up to 32 Lab units a pixel in steps of 1/64; larger ones share the last bin.
constexpr std::size_t kBins = 2048;
constexpr float kBinsPerUnit = 64;
/// Smaller than this is no change at all: rounding in the tables of the Lab conversion.
constexpr float kNoChange = 1e-3f;
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

struct Sizes {
  Histogram all{};
  std::size_t still = 0;  ///< how many of the first bin are no change at all
};

/// In two steps a block of pixels: the bins with SIMD, then the counts.
Sizes sizesOf(std::span<const float> gradientX, std::span<const float> gradientY) {
  constexpr std::size_t kBlock = 512;
  std::array<std::int32_t, kBlock> bins;
  std::array<std::array<std::uint32_t, kBins>, 2> counts{};
  Sizes sizes;
  for (std::size_t from = 0; from < gradientX.size(); from += kBlock) {
    const std::size_t count = std::min(kBlock, gradientX.size() - from);
    const float *x = gradientX.data() + from, *y = gradientY.data() + from;
    std::int32_t still = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const float size = std::sqrt(x[i] * x[i] + y[i] * y[i]);
      const float bin = size * kBinsPerUnit;
      bins[i] = static_cast<std::int32_t>(bin < kBins - 1 ? bin : kBins - 1);
      still += size > kNoChange ? 0 : 1;
    }
    sizes.still += static_cast<std::size_t>(still);
    // Neighbours often share a bin: two tables spare the wait for the count just written.
    for (std::size_t i = 0; i < count; ++i) ++counts[i & 1][static_cast<std::size_t>(bins[i])];
  }
  for (std::size_t bin = 0; bin < kBins; ++bin) sizes.all[bin] = counts[0][bin] + counts[1][bin];
  return sizes;
}

}  // namespace

Thresholds chooseThresholds(std::span<const float> gradientX, std::span<const float> gradientY) {
  const std::size_t count = std::min(gradientX.size(), gradientY.size());
  const Sizes sizes = sizesOf(gradientX.first(count), gradientY.first(count));
  const Histogram& all = sizes.all;
  Histogram changing = all;
  changing[0] -= sizes.still;
  const std::size_t moving = count - sizes.still;
  // With most of the picture digitally flat, what changes is the drawing itself, not noise.
  const double noise = 2 * moving > count ? quantile(changing, moving, kQuietShare) / kRayleighOfQuietShare : 0;
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
