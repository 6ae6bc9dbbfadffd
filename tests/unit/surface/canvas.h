// Small pictures for tests of what is seen of parts, painted pixel by pixel.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>

#include "engine/base/rng.h"
#include "engine/image/image.h"

namespace spineloft::surface {

using Rgb = std::array<int, 3>;

struct Canvas {
  int width, height;

  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  /// With the noise of a camera, the same one every time.
  image::Image picture(const std::function<Rgb(int x, int y)>& colour) const {
    Rng rng(7);
    image::Image out{width, height, {}};
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        for (const int c : colour(x, y))
          out.pixels.push_back(static_cast<std::uint8_t>(c + int(8 * rng.uniform()) - 4));
        out.pixels.push_back(255);
      }
    }
    return out;
  }
  /// 255 where `inside`.
  image::Mask mask(const std::function<bool(int x, int y)>& inside) const {
    image::Mask out{width, height, {}};
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) out.pixels.push_back(inside(x, y) ? 255 : 0);
    }
    return out;
  }
};

}  // namespace spineloft::surface
