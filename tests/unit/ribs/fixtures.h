// Spines and edge maps that the tests of ribs/ share.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "engine/base/rng.h"
#include "engine/image/edge_map.h"
#include "engine/ribs/base/spine.h"
#include "engine/vision/edges.h"

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

/// The map of a picture in which `inside` says which pixels belong to a dark thing on a light ground, from 4 × 4
/// samples a pixel, with noise of a few grey levels: what the product makes of it.
inline image::EdgeMap mapOf(image::Size size, const std::function<bool(PicturePoint)>& inside) {
  constexpr int kSub = 4;
  constexpr double kThing = 71, kGround = 226, kNoise = 4;
  Rng rng(11);
  image::Image image{size.width, size.height, {}};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      int in = 0;
      for (int i = 0; i < kSub * kSub; ++i) {
        in += inside({x + (i % kSub + 0.5) / kSub - 0.5, y + (i / kSub + 0.5) / kSub - 0.5}) ? 1 : 0;
      }
      const double grey = kGround - (kGround - kThing) * in / (kSub * kSub) + rng.uniform(-kNoise, kNoise);
      const auto value = static_cast<std::uint8_t>(std::lround(grey));
      for (const std::uint8_t channel : {value, value, value, std::uint8_t{255}}) image.pixels.push_back(channel);
    }
  }
  return vision::detectEdges({std::move(image), size.width, size.height}, {}, Progress()).value();
}

}  // namespace spineloft::fixtures
