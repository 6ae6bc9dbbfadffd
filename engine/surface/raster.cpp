#include "engine/surface/raster.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace spineloft::surface {
namespace {

/// Where the edge crosses row y, when it does: its upper end counts, its lower one does not. The
/// two triangles of an edge get the very same number.
bool crossing(PicturePoint a, PicturePoint b, double y, double& x) {
  if (b.y < a.y || (b.y == a.y && b.x < a.x)) std::swap(a, b);
  if (!(a.y <= y && y < b.y)) return false;
  x = a.x + (y - a.y) * ((b.x - a.x) / (b.y - a.y));
  return true;
}

}  // namespace

void coverTriangle(const std::array<PicturePoint, 3>& t, image::Mask& mask) {
  const double low = std::min({t[0].y, t[1].y, t[2].y}), high = std::max({t[0].y, t[1].y, t[2].y});
  const double lastRow = mask.height - 1.0;
  const int first = static_cast<int>(std::ceil(std::clamp(low, 0.0, lastRow + 1)));
  const int last = static_cast<int>(std::floor(std::clamp(high, -1.0, lastRow)));
  for (int row = first; row <= last; ++row) {
    std::array<double, 3> at{};
    std::size_t found = 0;
    for (std::size_t edge = 0; edge < 3; ++edge) {
      found += crossing(t[edge], t[(edge + 1) % 3], row, at[found]) ? 1 : 0;
    }
    if (found != 2) continue;
    const double width = mask.width;
    const auto from = static_cast<std::ptrdiff_t>(std::ceil(std::clamp(std::min(at[0], at[1]), 0.0, width)));
    const auto to = static_cast<std::ptrdiff_t>(std::ceil(std::clamp(std::max(at[0], at[1]), 0.0, width)));
    const auto begin = mask.pixels.begin() + static_cast<std::ptrdiff_t>(row) * mask.width;
    if (to > from) std::fill(begin + from, begin + to, std::uint8_t{255});
  }
}

}  // namespace spineloft::surface
