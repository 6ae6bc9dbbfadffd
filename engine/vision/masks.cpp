#include "engine/vision/masks.h"

namespace spineloft::vision {

cv::Mat plainMask(cv::Size size, int value) { return {size, CV_8UC1, cv::Scalar(value)}; }

cv::Mat grown(const cv::Mat& mask, int value) {
  cv::Mat out = mask.clone();
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      const auto is = [&](int u, int v) {
        return u >= 0 && v >= 0 && u < mask.cols && v < mask.rows && mask.at<std::uint8_t>(v, u) == value;
      };
      if (is(x - 1, y) || is(x + 1, y) || is(x, y - 1) || is(x, y + 1)) {
        out.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(value);
      }
    }
  }
  return out;
}

cv::Mat doubled(const cv::Mat& mask) {
  cv::Mat out = plainMask({2 * mask.cols + 2, 2 * mask.rows + 2});
  for (int y = 0; y < 2 * mask.rows; ++y) {
    for (int x = 0; x < 2 * mask.cols; ++x) {
      out.at<std::uint8_t>(y + 1, x + 1) = mask.at<std::uint8_t>(y / 2, x / 2);
    }
  }
  return out;
}

Pieces::Pieces(const cv::Mat& mask) : piece(mask.total(), 0), area{0} {
  for (int pixel = 0; pixel < static_cast<int>(mask.total()); ++pixel) {
    const int next = count();
    const int pixels = flood(mask.size(), pixel, [&](int at) {
      int& mine = piece[static_cast<std::size_t>(at)];
      if (mine != 0 || mask.data[at] == 0) return false;
      mine = next;
      return true;
    });
    if (pixels > 0) area.push_back(pixels);
  }
}

std::vector<bool> Pieces::touched(const cv::Mat& mask) const {
  std::vector<bool> out(area.size(), false);
  for (std::size_t pixel = 0; pixel < piece.size(); ++pixel) {
    if (mask.data[pixel] != 0) out[static_cast<std::size_t>(piece[pixel])] = true;
  }
  return out;
}

}  // namespace spineloft::vision
