// Spines and edge maps that the tests of ribs/ share.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "engine/base/rng.h"
#include "engine/image/edge_map.h"
#include "engine/ribs/base/spine.h"

namespace spineloft::fixtures {

using Points = std::vector<PicturePoint>;

/// A meandering open line of `count` points, about `step` apart, whose heading wanders slowly.
inline Points wander(Rng& rng, std::size_t count, double step) {
  Points p{{rng.uniform(300, 500), rng.uniform(300, 500)}};
  double heading = rng.uniform(0, 6.28), bend = 0;
  while (p.size() < count) {
    bend = 0.9 * bend + rng.uniform(-0.02, 0.02);
    heading += bend;
    p.push_back(p.back() + PicturePoint{std::cos(heading), std::sin(heading)} * step);
  }
  return p;
}

/// The map of a picture in which `inside` says which pixels belong to a dark thing on a light
/// ground: edges, proximity, colour and its gradient as the edge detector would give them.
inline image::EdgeMap mapOf(image::Size size, const std::function<bool(PicturePoint)>& inside) {
  image::EdgeMap map;
  map.width = size.width;
  map.height = size.height;
  map.reach = 5;
  const auto w = static_cast<std::size_t>(size.width), h = static_cast<std::size_t>(size.height);
  std::vector<float> light(w * h);
  constexpr int kSub = 4;
  for (std::size_t y = 0; y < h; ++y) {
    for (std::size_t x = 0; x < w; ++x) {
      int in = 0;
      for (int i = 0; i < kSub * kSub; ++i) {
        const double u = (i % kSub + 0.5) / kSub - 0.5, v = (i / kSub + 0.5) / kSub - 0.5;
        in += inside({static_cast<double>(x) + u, static_cast<double>(y) + v}) ? 1 : 0;
      }
      light[y * w + x] = 90.f - 60.f * static_cast<float>(in) / (kSub * kSub);
    }
  }
  const auto at = [&](std::ptrdiff_t x, std::ptrdiff_t y) {
    x = std::clamp<std::ptrdiff_t>(x, 0, size.width - 1);
    y = std::clamp<std::ptrdiff_t>(y, 0, size.height - 1);
    return light[static_cast<std::size_t>(y) * w + static_cast<std::size_t>(x)];
  };
  map.edges.assign(w * h, 0);
  map.gradientX.resize(w * h);
  map.gradientY.resize(w * h);
  map.look.assign(w * h, {});
  for (std::ptrdiff_t y = 0; y < size.height; ++y) {
    for (std::ptrdiff_t x = 0; x < size.width; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * w + static_cast<std::size_t>(x);
      map.gradientX[i] = (at(x + 1, y) - at(x - 1, y)) / 2;
      map.gradientY[i] = (at(x, y + 1) - at(x, y - 1)) / 2;
      map.look[i].set(0, at(x, y));
      // An edge where the lightness passes the middle to the next pixel on the right or below.
      const bool here = at(x, y) < 60, right = at(x + 1, y) < 60, below = at(x, y + 1) < 60;
      if (here != right || here != below) map.edges[i] = 255;
    }
  }
  const auto reach = static_cast<std::ptrdiff_t>(map.reach);
  for (std::ptrdiff_t y = 0; y < size.height; ++y) {
    for (std::ptrdiff_t x = 0; x < size.width; ++x) {
      if (!map.edges[static_cast<std::size_t>(y) * w + static_cast<std::size_t>(x)]) continue;
      for (std::ptrdiff_t v = std::max<std::ptrdiff_t>(0, y - reach);
           v <= std::min<std::ptrdiff_t>(size.height - 1, y + reach); ++v) {
        for (std::ptrdiff_t u = std::max<std::ptrdiff_t>(0, x - reach);
             u <= std::min<std::ptrdiff_t>(size.width - 1, x + reach); ++u) {
          const double away = std::hypot(static_cast<double>(u - x), static_cast<double>(v - y));
          image::PixelFeature& look = map.look[static_cast<std::size_t>(v) * w + static_cast<std::size_t>(u)];
          look.set(3, std::max(look[3], static_cast<float>(1 - away / map.reach)));
        }
      }
    }
  }
  return map;
}

}  // namespace spineloft::fixtures
