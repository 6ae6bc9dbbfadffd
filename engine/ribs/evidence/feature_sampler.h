// The look of a picture (image::EdgeMap::look) between the map's pixels.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "engine/base/lanes.h"
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

  /// The first of the four pixels around a place, and where between them it is: shares 0 … 1 of the way right and down.
  struct Place {
    std::size_t first;
    float u, v;
  };
  /// Map coordinates (x, y, –, –).
  Place locate(Float4 at) const {
    const Float4 held = least4(most4(at, all4(0)), most_);
    const Int4 start = __builtin_convertvector(least4(held, mostStart_), Int4);
    const Float4 share = held - __builtin_convertvector(start, Float4);
    return {static_cast<std::size_t>(start[1]) * row_ + static_cast<std::size_t>(start[0]), share[0], share[1]};
  }
  std::size_t nearest(const Place& p) const { return p.first + (p.u < 0.5f ? 0 : right_) + (p.v < 0.5f ? 0 : below_); }

  /// Lab and nearness.
  Float4 featureAt(const Place& p) const {
    const auto* first = look_ + p.first;
    const auto at = [](const image::PixelFeature* look) { return load4(look->fixed.data()); };
    return mix({at(first), at(first + right_), at(first + below_), at(first + below_ + right_)}, p);
  }
  /// With another plane's nearness than the map's.
  Float4 featureAt(const Place& p, const std::vector<float>& nearness) const {
    const auto at = [&](std::size_t pixel) {
      Float4 look = load4(look_[pixel].fixed.data());
      look[3] = nearness[pixel] * image::PixelFeature::kNear;
      return look;
    };
    const std::size_t below = p.first + below_;
    return mix({at(p.first), at(p.first + right_), at(below), at(below + right_)}, p);
  }

 private:
  struct Four {
    Float4 a, b, c, d;
  };
  static Float4 mix(const Four& f, const Place& p) {
    const Float4 top = f.a + (f.b - f.a) * p.u, bottom = f.c + (f.d - f.c) * p.u;
    constexpr Float4 kUnit{1 / image::PixelFeature::kLab, 1 / image::PixelFeature::kLab, 1 / image::PixelFeature::kLab,
                           1 / image::PixelFeature::kNear};
    return (top + (bottom - top) * p.v) * kUnit;
  }

  const image::PixelFeature* look_;
  std::size_t row_, right_, below_;
  Float4 most_, mostStart_;
};

}  // namespace spineloft::ribs
