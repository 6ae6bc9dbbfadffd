#include "engine/vision/contours.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace spineloft::vision {
namespace {

/// Gradients are compared as whole numbers, so that every platform finds the same edges; this many steps a Lab unit
/// keep faint edges, and no product overflows (the steepest step between two sRGB colours is below 130 Lab units a
/// pixel).
constexpr float kStepsPerUnit = 128, kMostUnits = 200, kMost = kMostUnits * kStepsPerUnit;

/// What a pixel is before it is known which contour it is on.
enum Mark : std::uint8_t { kNone = 0, kWeak = 1, kStrong = 2 };

/// One row of a gradient in steps, and its squared size, which has a 0 on either side.
struct GradientRow {
  std::vector<std::int32_t> x, y, padded;
  explicit GradientRow(std::size_t width) : x(width), y(width), padded(width + 2) {}
  const std::int32_t* squared() const { return padded.data() + 1; }
};

/// To the nearest step: adding 1.5 · 2²³ leaves a float of this size rounded in the lowest bits of its pattern,
/// which SIMD reads faster than it converts.
void toSteps(const float* plane, std::size_t count, std::int32_t* __restrict out) {
  constexpr float kRounder = 12582912;
  constexpr std::int32_t kPattern = std::bit_cast<std::int32_t>(kRounder);
  for (std::size_t i = 0; i < count; ++i) {
    const float scaled = kStepsPerUnit * plane[i];
    const float low = scaled < -kMost ? -kMost : scaled;
    const float held = low > kMost ? kMost : low;
    out[i] = std::bit_cast<std::int32_t>(held + kRounder) - kPattern;
  }
}
void square(const std::int32_t* x, const std::int32_t* y, std::size_t count, std::int32_t* __restrict out) {
  for (std::size_t i = 0; i < count; ++i) out[i] = x[i] * x[i] + y[i] * y[i];
}

/// Squared sizes above which a maximum may be on a contour, and starts one.
struct Limits {
  std::int32_t low, high;
};

/// Choices by masks: all neighbours are read whichever is chosen, so that SIMD can do it.
std::int32_t mask(bool holds) { return -static_cast<std::int32_t>(holds); }
std::int32_t choose(std::int32_t mask, std::int32_t a, std::int32_t b) { return b ^ ((a ^ b) & mask); }

/// Three rows of squared gradient sizes.
struct SizeRows {
  const std::int32_t *up, *here, *down;
};

/// Canny's thin maxima: a pixel stays if no neighbour along its gradient is steeper, and of two equal ones the later
/// goes (of two across a corner both). The direction is one of four, told by tan 22.5° in 1/2¹⁵.
void suppressRow(const SizeRows& rows, const GradientRow& gradient, const Limits& limits,
                 std::int32_t* __restrict out) {
  constexpr int kShift = 15, kTan = 13573;
  const std::int32_t *u = rows.up, *m = rows.here, *d = rows.down, *dx = gradient.x.data(), *dy = gradient.y.data();
  const std::int32_t low = limits.low, high = limits.high;
  const auto count = static_cast<std::ptrdiff_t>(gradient.x.size());  // signed, for column −1 is read
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const std::int32_t x = dx[i] < 0 ? -dx[i] : dx[i], y = (dy[i] < 0 ? -dy[i] : dy[i]) << kShift;
    const std::int32_t flatter = x * kTan, steeper = flatter + (x << (kShift + 1)), size = m[i];
    const std::int32_t along = mask(y < flatter), across = mask(y > steeper), rising = (dx[i] ^ dy[i]) >> 31;
    const std::int32_t cornerBefore = choose(rising, u[i + 1], u[i - 1]);
    const std::int32_t cornerAfter = choose(rising, d[i - 1], d[i + 1]);
    const std::int32_t before = choose(along, m[i - 1], choose(across, u[i], cornerBefore));
    const std::int32_t after = choose(along, m[i + 1], choose(across, d[i], cornerAfter));
    const std::int32_t tie = (along | across) & 1;
    const std::int32_t top = mask(size > low) & mask(size > before) & mask(size + tie > after);
    out[i] = top & (kWeak + (mask(size > high) & (kStrong - kWeak)));
  }
}

std::vector<std::uint8_t> maxima(const image::EdgeMap& map, const Limits& limits) {
  const auto width = static_cast<std::size_t>(map.width), height = static_cast<std::size_t>(map.height);
  std::vector<std::uint8_t> marks(width * height);
  std::array<GradientRow, 3> ring{GradientRow(width), GradientRow(width), GradientRow(width)};
  const std::vector<std::int32_t> beyond(width + 2);
  std::vector<std::int32_t> found(width);
  const auto read = [&](std::size_t y) {
    GradientRow& row = ring[y % 3];
    toSteps(&map.gradientX[y * width], width, row.x.data());
    toSteps(&map.gradientY[y * width], width, row.y.data());
    square(row.x.data(), row.y.data(), width, row.padded.data() + 1);
  };
  read(0);
  for (std::size_t y = 0; y < height; ++y) {
    if (y + 1 < height) read(y + 1);
    const GradientRow& here = ring[y % 3];
    const std::int32_t* up = y > 0 ? ring[(y - 1) % 3].squared() : beyond.data() + 1;
    const std::int32_t* down = y + 1 < height ? ring[(y + 1) % 3].squared() : beyond.data() + 1;
    suppressRow({up, here.squared(), down}, here, limits, found.data());
    std::uint8_t* __restrict out = &marks[y * width];
    for (std::size_t x = 0; x < width; ++x) out[x] = static_cast<std::uint8_t>(found[x]);
  }
  return marks;
}

struct Contour {
  double sum = 0;  ///< of the gradient sizes
  std::vector<std::size_t> pixels;
};

/// Takes contours out of a picture of marks: what is weak counts where it is joined to what is strong.
class ContourWalk {
 public:
  ContourWalk(std::vector<std::uint8_t>& marks, const image::EdgeMap& map)
      : marks_(marks), map_(map), width_(static_cast<std::size_t>(map.width)) {}

  /// The 8-connected contour through a marked pixel. Its marks are cleared.
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
      if (marks_[at] != 0) add(at);
    }
  }
  void add(std::size_t at) {
    marks_[at] = 0;
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
  const auto squared = [](double threshold) {
    const double steps = static_cast<double>(kStepsPerUnit) * std::min(threshold, static_cast<double>(kMostUnits));
    return static_cast<std::int32_t>(std::floor(steps * steps));
  };
  std::vector<std::uint8_t> marks = maxima(map, {squared(thresholds.low), squared(thresholds.high)});
  map.edges.assign(marks.size(), 0);
  ContourWalk walk(marks, map);
  for (auto next = marks.begin(); (next = std::find(next, marks.end(), kStrong)) != marks.end(); ++next) {
    const Contour& contour = walk.take(static_cast<std::size_t>(next - marks.begin()));
    const int count = static_cast<int>(contour.pixels.size());
    if (!isContour(contour.sum, count, thresholds.noise)) continue;
    for (const std::size_t pixel : contour.pixels) map.edges[pixel] = 255;
  }
}

}  // namespace spineloft::vision
