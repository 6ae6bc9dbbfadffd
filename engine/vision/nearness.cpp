#include "engine/vision/nearness.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace spineloft::vision {
namespace {

/// Squared distance along one row to its nearest edge, at most `reach` squared.
void alongRow(const std::uint8_t* edges, std::size_t count, int reach, float* out) {
  int away = reach;
  for (std::size_t x = 0; x < count; ++x) {
    away = edges[x] != 0 ? 0 : std::min(away + 1, reach);
    out[x] = static_cast<float>(away);
  }
  away = reach;
  for (std::size_t x = count; x-- > 0;) {
    away = edges[x] != 0 ? 0 : std::min(away + 1, reach);
    const float least = std::min(out[x], static_cast<float>(away));
    out[x] = least * least;
  }
}

/// best = min(best, other + add).
void lower(const float* __restrict other, float add, std::size_t count, float* __restrict best) {
  for (std::size_t x = 0; x < count; ++x) {
    const float there = other[x] + add;
    best[x] = there < best[x] ? there : best[x];
  }
}

}  // namespace

void fillProximity(image::EdgeMap& map) {
  const auto width = static_cast<std::size_t>(map.width), height = static_cast<std::size_t>(map.height);
  // Nothing farther than the ramp's end matters, so rows farther than that need not be looked at.
  const int reach = std::max(1, static_cast<int>(std::ceil(map.reach)));
  std::vector<float> rows(width * height), best(width);
  for (std::size_t y = 0; y < height; ++y)
    alongRow(&map.edges[y * width], width, reach, &rows[y * width]);
  const auto ramp = static_cast<float>(1 / map.reach);
  for (std::size_t y = 0; y < height; ++y) {
    std::copy_n(&rows[y * width], width, best.data());
    for (std::size_t step = 1; step < static_cast<std::size_t>(reach); ++step) {
      const auto add = static_cast<float>(step * step);
      if (step <= y) lower(&rows[(y - step) * width], add, width, best.data());
      if (y + step < height) lower(&rows[(y + step) * width], add, width, best.data());
    }
    for (float& value : best) {
      const float near = 1 - std::sqrt(value) * ramp;
      value = near > 0 ? near : 0;
    }
    for (std::size_t x = 0; x < width; ++x) map.look[y * width + x][3] = best[x];
  }
}

}  // namespace spineloft::vision
