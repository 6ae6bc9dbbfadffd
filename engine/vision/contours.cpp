#include "engine/vision/contours.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace spineloft::vision {
namespace {

/// This many steps a Lab unit keep faint edges, and the squares of steps fit into 32 bits (the
/// steepest step between two sRGB colours is below 130 Lab units a pixel).
constexpr float kStepsPerUnit = 128;
/// tan 22.5° in 1/32768: between it and tan 67.5° = tan 22.5° + 2 a gradient is diagonal.
constexpr std::int64_t kTan22 = 13573, kTanOne = 32768;

constexpr std::uint8_t kNothing = 0, kMarked = 1;

/// The gradient of one row in steps, and its squared size with a 0 on either side.
struct Row {
  std::vector<std::int16_t> x, y;
  std::vector<std::int32_t> squared;
  explicit Row(std::size_t width) : x(width), y(width), squared(width + 2) {}
  void clear() { std::fill(squared.begin(), squared.end(), 0); }
};

/// To the nearest step. Adding 1.5 · 2²³ leaves a float of this size rounded in the lowest bits of
/// its pattern, which SIMD reads faster than it converts.
void inSteps(const float* gradient, std::size_t count, std::int16_t* __restrict steps) {
  constexpr float kRounder = 12582912, kMost = 255 * kStepsPerUnit;
  constexpr std::int32_t kPattern = std::bit_cast<std::int32_t>(kRounder);
  for (std::size_t i = 0; i < count; ++i) {
    const float scaled = kStepsPerUnit * gradient[i];
    const float low = scaled < -kMost ? -kMost : scaled;
    const float held = low > kMost ? kMost : low;
    steps[i] = static_cast<std::int16_t>(std::bit_cast<std::int32_t>(held + kRounder) - kPattern);
  }
}

void readRow(const image::EdgeMap& map, int y, Row& row) {
  const std::size_t width = row.x.size(), start = static_cast<std::size_t>(y) * width;
  inSteps(map.gradientX.data() + start, width, row.x.data());
  inSteps(map.gradientY.data() + start, width, row.y.data());
  const std::int16_t *gx = row.x.data(), *gy = row.y.data();
  std::int32_t* __restrict squared = row.squared.data() + 1;
  for (std::size_t i = 0; i < width; ++i) squared[i] = gx[i] * gx[i] + gy[i] * gy[i];
}

/// The largest whole number whose being exceeded means to exceed the threshold.
std::int32_t squaredSteps(double threshold) {
  const double steps = std::min(32767.0, kStepsPerUnit * threshold);
  return static_cast<std::int32_t>(std::floor(steps * steps));
}

struct ThreeRows {
  const Row &above, &here, &below;
};

/// Whether pixel `i` is the strongest across its contour.
bool isCrest(const ThreeRows& rows, std::size_t i) {
  const std::int32_t *up = rows.above.squared.data() + 1 + i,
                     *at = rows.here.squared.data() + 1 + i,
                     *down = rows.below.squared.data() + 1 + i;
  const std::int64_t x = std::abs(rows.here.x[i]), y = std::abs(rows.here.y[i]) * kTanOne;
  if (y < x * kTan22) return *at > at[-1] && *at >= at[1];
  if (y > x * (kTan22 + 2 * kTanOne)) return *at > *up && *at >= *down;
  const std::ptrdiff_t side = (rows.here.x[i] ^ rows.here.y[i]) < 0 ? -1 : 1;
  return *at > up[-side] && *at > down[side];
}

struct Marks {
  std::vector<std::uint8_t> pixels;
  std::vector<std::size_t> strong;  ///< where the strong ones are
};

Marks markCrests(const Thresholds& thresholds, const image::EdgeMap& map) {
  const std::size_t width = static_cast<std::size_t>(map.width);
  const std::int32_t low = squaredSteps(thresholds.low), high = squaredSteps(thresholds.high);
  Marks marks{std::vector<std::uint8_t>(map.gradientX.size(), kNothing), {}};
  std::vector<Row> ring(3, Row(width));
  readRow(map, 0, ring[0]);
  for (int y = 0; y < map.height; ++y) {
    Row &above = ring[static_cast<std::size_t>(y + 2) % 3],
        &here = ring[static_cast<std::size_t>(y) % 3],
        &below = ring[static_cast<std::size_t>(y + 1) % 3];
    if (y + 1 < map.height) {
      readRow(map, y + 1, below);
    } else {
      below.clear();
    }
    const std::size_t start = width * static_cast<std::size_t>(y);
    const std::int32_t* squared = here.squared.data() + 1;
    for (std::size_t i = 0; i < width; ++i) {
      if (squared[i] <= low || !isCrest({above, here, below}, i)) continue;
      marks.pixels[start + i] = kMarked;
      if (squared[i] > high) marks.strong.push_back(start + i);
    }
  }
  return marks;
}

struct Contour {
  double sum = 0;  ///< of the gradient sizes
  std::vector<std::size_t> pixels;
};

/// Takes contours out of a picture of marks.
class ContourWalk {
 public:
  ContourWalk(std::vector<std::uint8_t>& marks, const image::EdgeMap& map)
      : marks_(marks), map_(map), width_(static_cast<std::size_t>(map.width)) {}

  /// The contour through a marked pixel. Its marks are cleared.
  const Contour& take(std::size_t start) {
    contour_.sum = 0;
    contour_.pixels.clear();
    add(start);
    for (std::size_t next = 0; next < contour_.pixels.size(); ++next) {
      const std::size_t at = contour_.pixels[next], x = at % width_;
      const std::size_t left = x > 0 ? at - 1 : at, right = x + 1 < width_ ? at + 1 : at;
      addMarked(left, right);
      if (at >= width_) addMarked(left - width_, right - width_);
      if (at + width_ < marks_.size()) addMarked(left + width_, right + width_);
    }
    return contour_;
  }

 private:
  void addMarked(std::size_t first, std::size_t last) {
    for (std::size_t at = first; at <= last; ++at) {
      if (marks_[at] != kNothing) add(at);
    }
  }
  void add(std::size_t at) {
    marks_[at] = kNothing;
    contour_.pixels.push_back(at);
    const float x = map_.gradientX[at], y = map_.gradientY[at];
    contour_.sum += std::sqrt(x * x + y * y);
  }

  std::vector<std::uint8_t>& marks_;
  const image::EdgeMap& map_;
  std::size_t width_;
  Contour contour_;
};

}  // namespace

void fillEdges(const Thresholds& thresholds, image::EdgeMap& map) {
  Marks marks = markCrests(thresholds, map);
  map.edges.assign(marks.pixels.size(), 0);
  ContourWalk walk(marks.pixels, map);
  for (const std::size_t start : marks.strong) {
    if (marks.pixels[start] == kNothing) continue;  // walked with another
    const Contour& contour = walk.take(start);
    const int count = static_cast<int>(contour.pixels.size());
    if (!isContour(contour.sum, count, thresholds.noise)) continue;
    for (const std::size_t pixel : contour.pixels) map.edges[pixel] = 255;
  }
}

}  // namespace spineloft::vision
