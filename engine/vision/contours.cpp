#include "engine/vision/contours.h"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace spineloft::vision {
namespace {

/// OpenCV's Canny takes 16-bit derivatives; this many steps a Lab unit keep faint edges and cannot
/// overflow (the steepest step between two sRGB colours is below 130 Lab units a pixel).
constexpr float kStepsPerUnit = 128;

/// To the nearest step. Not cv::Mat::convertTo, which rounds negative numbers up in OpenCV's
/// WebAssembly build; adding 1.5 · 2²³ leaves a float of this size rounded in the lowest bits of its
/// pattern, which SIMD reads faster than it converts.
cv::Mat inSteps(const image::EdgeMap& map, const std::vector<float>& plane) {
  constexpr float kRounder = 12582912, kMost = 255 * kStepsPerUnit;
  constexpr std::int32_t kPattern = std::bit_cast<std::int32_t>(kRounder);
  cv::Mat steps(map.height, map.width, CV_16SC1);
  std::int16_t* __restrict out = steps.ptr<std::int16_t>();
  for (std::size_t i = 0; i < plane.size(); ++i) {
    const float scaled = kStepsPerUnit * plane[i];
    const float low = scaled < -kMost ? -kMost : scaled;
    const float held = low > kMost ? kMost : low;
    out[i] = static_cast<std::int16_t>(std::bit_cast<std::int32_t>(held + kRounder) - kPattern);
  }
  return steps;
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
  std::vector<std::uint8_t> marks(map.gradientX.size());
  cv::Mat found(map.height, map.width, CV_8UC1, marks.data());
  cv::Canny(inSteps(map, map.gradientX), inSteps(map, map.gradientY), found,
            static_cast<double>(kStepsPerUnit) * thresholds.low,
            static_cast<double>(kStepsPerUnit) * thresholds.high, true);
  map.edges.assign(marks.size(), 0);
  ContourWalk walk(marks, map);
  for (std::size_t start = 0; start < marks.size(); ++start) {
    if (marks[start] == 0) continue;
    const Contour& contour = walk.take(start);
    const int count = static_cast<int>(contour.pixels.size());
    if (!isContour(contour.sum, count, thresholds.noise)) continue;
    for (const std::size_t pixel : contour.pixels) map.edges[pixel] = 255;
  }
}

}  // namespace spineloft::vision
