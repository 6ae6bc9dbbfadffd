// Masks of one byte a pixel, as cv::Mat: the few operations that a cut-out needs. OpenCV's own come for every type of
// pixel at once, which is a megabyte of WebAssembly. Internal to vision/.
#pragma once

#include <cstddef>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

namespace spineloft::vision {

/// A mask that is `value` everywhere.
cv::Mat plainMask(cv::Size size, int value = 0);

/// A mask that is 255 where `holds(pixel)`; pixels are counted row by row.
template <class Holds>
cv::Mat maskWhere(cv::Size size, Holds holds) {
  cv::Mat mask(size, CV_8UC1);
  for (int pixel = 0; pixel < size.area(); ++pixel) mask.data[pixel] = holds(pixel) ? 255 : 0;
  return mask;
}

/// Pixels of `value` (0 or 255), and those beside, above or below one of them.
cv::Mat grown(const cv::Mat& mask, int value);

/// Each pixel as two by two, with one pixel of 0 all round.
cv::Mat doubled(const cv::Mat& mask);

/// Visits the pixels that hang together with `from` over their sides. `take(pixel)` says whether one belongs to them
/// and has not been taken before. Returns how many there are.
template <class Take>
int flood(cv::Size size, int from, Take take) {
  int count = 0;
  std::vector<int> open;
  const auto visit = [&](int pixel) {
    if (!take(pixel)) return;
    ++count;
    open.push_back(pixel);
  };
  visit(from);
  while (!open.empty()) {
    const int pixel = open.back(), x = pixel % size.width, y = pixel / size.width;
    open.pop_back();
    if (x > 0) visit(pixel - 1);
    if (x + 1 < size.width) visit(pixel + 1);
    if (y > 0) visit(pixel - size.width);
    if (y + 1 < size.height) visit(pixel + size.width);
  }
  return count;
}

/// The pieces of a mask that hang together over the sides of pixels.
struct Pieces {
  std::vector<int> piece;  ///< of each pixel, from 1; 0 is outside the mask
  std::vector<int> area;   ///< by piece, in pixels; of 0: 0
  explicit Pieces(const cv::Mat& mask);
  int count() const { return static_cast<int>(area.size()); }
  int of(int pixel) const { return piece[static_cast<std::size_t>(pixel)]; }
  /// By piece: whether it has a pixel of `mask`.
  std::vector<bool> touched(const cv::Mat& mask) const;
};

}  // namespace spineloft::vision
