// The look of a picture (image::EdgeMap::look) between the map's pixels, in whole numbers: sums of it are exact.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/base/short_lanes.h"
#include "engine/image/edge_map.h"

namespace spineloft::ribs {

/// Bilinear, held to the map. The map is not empty and outlives the sampler.
class FeatureSampler {
 public:
  explicit FeatureSampler(const image::EdgeMap& map)
      : look_(map.look.data()),
        row_(static_cast<std::size_t>(map.width)),
        right_(map.width > 1 ? 1 : 0),
        below_(map.height > 1 ? row_ : 0),
        most_{static_cast<float>(map.width - 1), static_cast<float>(map.height - 1), 0, 0},
        mostStart_{static_cast<float>(std::max(0, map.width - 2)), static_cast<float>(std::max(0, map.height - 2)), 0,
                   0} {}

  /// The first of the four pixels around a place, and where between them it is: 0 … kShare of the way right and down.
  struct Place {
    std::size_t first;
    std::int32_t right, down;
  };
  static constexpr int kShareBits = 14;
  static constexpr std::int32_t kShare = 1 << kShareBits;
  /// Map coordinates (x, y, –, –), below 2¹⁷.
  Place locate(Float4 at) const {
    const Float4 held = least4(most4(at, all4(0)), most_);
    const Int4 start = __builtin_convertvector(least4(held, mostStart_), Int4);
    const Int4 share = __builtin_convertvector(held * static_cast<float>(kShare) + 0.5f, Int4) - (start << kShareBits);
    return {static_cast<std::size_t>(start[1]) * row_ + static_cast<std::size_t>(start[0]), share[0], share[1]};
  }
  std::size_t nearest(const Place& p) const {
    return p.first + (2 * p.right < kShare ? 0 : right_) + (2 * p.down < kShare ? 0 : below_);
  }

  /// Lab and nearness, in units of 1 / (kUnits · PixelFeature's): the sum of kMostSamples does not leave 32 bits.
  static constexpr std::int32_t kUnits = 1 << 11;
  static constexpr int kMostSamples = 17;
  Int4 featureAt(const Place& p) const {
    const image::PixelFeature *above = look_ + p.first, *below = above + below_;
    return mix({pixel(*above), pixel(above[right_]), pixel(*below), pixel(below[right_])}, p);
  }
  /// With another plane's nearness than the map's.
  Int4 featureAt(const Place& p, const std::vector<float>& nearness) const {
    const auto at = [&](std::size_t i) {
      Short8 look = pixel(look_[i]);
      look[3] = static_cast<std::int16_t>(std::lround(nearness[i] * image::PixelFeature::kNear));
      return look;
    };
    const std::size_t below = p.first + below_;
    return mix({at(p.first), at(p.first + right_), at(below), at(below + right_)}, p);
  }
  /// The mean of `count` features, from their sum.
  static Float4 meanOf(Int4 sum, int count) {
    constexpr float kLab = 1 / (kUnits * image::PixelFeature::kLab), kNear = 1 / (kUnits * image::PixelFeature::kNear);
    return __builtin_convertvector(sum, Float4) / static_cast<float>(count) * Float4{kLab, kLab, kLab, kNear};
  }

 private:
  // Lanes beyond the fourth are 0.
  static Short8 pixel(const image::PixelFeature& look) {
    std::int64_t all = 0;
    __builtin_memcpy(&all, look.fixed.data(), sizeof all);
    return std::bit_cast<Short8>(Long2{all, 0});
  }
  struct Four {
    Short8 a, b, c, d;
  };
  static Int4 mix(const Four& f, const Place& p) {
    // The four shares sum to kShare.
    const std::int32_t d = (p.right * p.down + kShare / 2) >> kShareBits, b = p.right - d, c = p.down - d,
                       a = kShare - p.right - c;
    const auto both = [](std::int32_t left, std::int32_t right) {
      const std::int32_t pair = left | (right << 16);
      return std::bit_cast<Short8>(Int4{pair, pair, pair, pair});
    };
    const Short8 above = __builtin_shufflevector(f.a, f.b, 0, 8, 1, 9, 2, 10, 3, 11),
                 below = __builtin_shufflevector(f.c, f.d, 0, 8, 1, 9, 2, 10, 3, 11);
    return (dotPairs(above, both(a, b)) + dotPairs(below, both(c, d))) >> (kShareBits - 11);
  }

  const image::PixelFeature* look_;
  std::size_t row_, right_, below_;
  Float4 most_, mostStart_;
};

}  // namespace spineloft::ribs
