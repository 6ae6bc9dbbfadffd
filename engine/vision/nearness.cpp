#include "engine/vision/nearness.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace spineloft::vision {
namespace {

/// One row farther from the last edge of every column, at most `reach`; 0 on an edge.
void goOn(const std::uint8_t* edges, std::uint16_t reach, std::size_t count, std::uint16_t* __restrict away) {
  for (std::size_t x = 0; x < count; ++x) {
    const auto next = static_cast<std::uint16_t>(away[x] + 1);
    const std::uint16_t held = next < reach ? next : reach;
    away[x] = edges[x] != 0 ? std::uint16_t{0} : held;
  }
}

/// Squares of the lesser of two distances.
template <class Square>
void squareLesser(const std::uint16_t* a, const std::uint16_t* b, std::size_t count, Square* __restrict out) {
  for (std::size_t x = 0; x < count; ++x) {
    const auto least = static_cast<Square>(a[x] < b[x] ? a[x] : b[x]);
    out[x] = static_cast<Square>(least * least);
  }
}

/// best = min(best, left + add, right + add).
template <class Square>
void lower(const Square* left, const Square* right, Square add, std::size_t count, Square* __restrict best) {
  for (std::size_t x = 0; x < count; ++x) {
    const auto there = static_cast<Square>((left[x] < right[x] ? left[x] : right[x]) + add);
    best[x] = there < best[x] ? there : best[x];
  }
}

/// The ramp of one row of squared distances.
template <class Square>
void slope(const Square* squares, float ramp, std::size_t count, float* __restrict values) {
  for (std::size_t x = 0; x < count; ++x) {
    const float near = 1 - std::sqrt(static_cast<float>(squares[x])) * ramp;
    values[x] = near > 0 ? near : 0;
  }
}

/// Square: of whole numbers, holds twice that of the reach.
template <class Square>
void fill(image::EdgeMap& map) {
  const auto width = static_cast<std::size_t>(map.width), height = static_cast<std::size_t>(map.height);
  // Nothing farther than the ramp's end matters, so columns farther than that need not be looked at.
  const auto reach = static_cast<std::size_t>(std::max(1, static_cast<int>(std::ceil(map.reach))));
  const auto most = static_cast<std::uint16_t>(reach);
  // Along the columns first, many at a time; then along one row at a time, which stays at hand.
  std::vector<std::uint16_t> above(width * height), away(width, most);
  for (std::size_t y = 0; y < height; ++y) {
    goOn(&map.edges[y * width], most, width, away.data());
    std::copy(away.begin(), away.end(), above.begin() + static_cast<std::ptrdiff_t>(y * width));
  }
  std::ranges::fill(away, most);
  const auto far = static_cast<Square>(reach * reach);
  const auto ramp = static_cast<float>(1 / map.reach);
  std::vector<Square> row(width + 2 * reach, far), best(width);
  std::vector<float> near(width);
  Square* squares = row.data() + reach;
  for (std::size_t y = height; y-- > 0;) {
    goOn(&map.edges[y * width], most, width, away.data());
    squareLesser(&above[y * width], away.data(), width, squares);
    std::copy_n(squares, width, best.data());
    for (std::size_t step = 1; step < reach; ++step)
      lower(squares - step, squares + step, static_cast<Square>(step * step), width, best.data());
    slope(best.data(), ramp, width, near.data());
    for (std::size_t x = 0; x < width; ++x)
      map.look[y * width + x].fixed[3] = static_cast<std::int16_t>(near[x] * image::PixelFeature::kNear + 0.5f);
  }
}

}  // namespace

void fillProximity(image::EdgeMap& map) {
  // Eight at a time where the squares fit into 16 bits, which they do unless the reach was chosen very long.
  constexpr double kShort = 127;
  map.reach <= kShort ? fill<std::int16_t>(map) : fill<std::int32_t>(map);
}

}  // namespace spineloft::vision
