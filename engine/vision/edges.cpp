#include "engine/vision/edges.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <new>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "engine/base/limits.h"
#include "engine/image/lab.h"
#include "engine/vision/thresholds.h"

namespace spineloft::vision {
namespace {

/// Canny works on 16-bit derivatives; this many steps a Lab unit keep faint edges and cannot
/// overflow (the steepest step between two sRGB colours is below 130 Lab units a pixel).
constexpr double kStepsPerUnit = 128;
/// Shortest ramp, in map pixels, so that tiny pictures still pull towards their edges.
constexpr double kShortestReach = 1.5;

/// OpenCV's own worker threads stay off: work is spread over pictures, not inside one, and the
/// result of a run must not depend on the number of processors.
void useOneThread() {
  static const bool kDone = [] {
    cv::setNumThreads(0);
    return true;
  }();
  static_cast<void>(kDone);
}

bool inRange(const EdgeParams& params) {
  return params.longSide >= 16 && params.longSide <= 4096 && params.blurSigma >= 0 &&
         params.blurSigma <= 5 && params.reachShare >= 0.001 && params.reachShare <= 0.1;
}

cv::Mat smoothLab(image::ImageView copy, double sigma) {
  std::vector<float> lab = image::labPixels(copy);
  const cv::Mat raw(copy.height, copy.width, CV_32FC3, lab.data());
  cv::Mat smooth;
  if (sigma > 0) {
    cv::GaussianBlur(raw, smooth, cv::Size(), sigma, sigma, cv::BORDER_REPLICATE);
  } else {
    smooth = raw.clone();
  }
  return smooth;
}

/// The direction and size of the strongest colour change (Di Zenzo 1986): the dominant eigenvector
/// of the sum over channels of ∇c ∇cᵀ, pointing where lightness grows, or where lightness is level,
/// where the channel that changes most grows.
struct Gradient {
  float x = 0, y = 0;
};
Gradient dominantGradient(const cv::Vec3f& dx, const cv::Vec3f& dy) {
  const float e = dx.dot(dx), f = dx.dot(dy), g = dy.dot(dy);
  const float root = std::sqrt((e - g) * (e - g) + 4 * f * f);
  const float strongest = (e + g + root) / 2;  // the larger eigenvalue of (e f; f g)
  if (!(strongest > 0)) return {};
  // Its eigenvector, from the row that does not vanish.
  float x = e >= g ? strongest - g : f, y = e >= g ? f : strongest - e;
  const float length = std::sqrt(x * x + y * y);
  // Level in all directions (root = 0): any direction will do.
  x = length > 0 ? x / length : 1.0f, y = length > 0 ? y / length : 0.0f;
  const float size = std::sqrt(strongest);
  float along = dx[0] * x + dy[0] * y;
  if (std::abs(along) <= 0.1f * size) {
    for (int c = 1; c < 3; ++c) {
      const float change = dx[c] * x + dy[c] * y;
      if (std::abs(change) > std::abs(along)) along = change;
    }
  }
  const float signedSize = along < 0 ? -size : size;
  return {signedSize * x, signedSize * y};
}

void gradientPlanes(const cv::Mat& lab, image::EdgeMap& map) {
  cv::Mat dx, dy;
  // Sobel's weights sum to 8: an eighth makes Lab units a pixel.
  cv::Sobel(lab, dx, CV_32F, 1, 0, 3, 1.0 / 8, 0, cv::BORDER_REPLICATE);
  cv::Sobel(lab, dy, CV_32F, 0, 1, 3, 1.0 / 8, 0, cv::BORDER_REPLICATE);
  const std::size_t count =
      static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height);
  map.gradientX.resize(count);
  map.gradientY.resize(count);
  std::size_t i = 0;
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x, ++i) {
      const Gradient g = dominantGradient(dx.at<cv::Vec3f>(y, x), dy.at<cv::Vec3f>(y, x));
      map.gradientX[i] = g.x;
      map.gradientY[i] = g.y;
    }
  }
}

/// Canny 1986 on the colour gradient: thinning and hysteresis are OpenCV's, thresholds ours.
cv::Mat cannyEdges(const image::EdgeMap& map, const Thresholds& thresholds) {
  cv::Mat dx(map.height, map.width, CV_16SC1), dy(map.height, map.width, CV_16SC1), edges;
  std::size_t i = 0;
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x, ++i) {
      dx.at<short>(y, x) = cv::saturate_cast<short>(kStepsPerUnit * map.gradientX[i]);
      dy.at<short>(y, x) = cv::saturate_cast<short>(kStepsPerUnit * map.gradientY[i]);
    }
  }
  cv::Canny(dx, dy, edges, kStepsPerUnit * thresholds.low, kStepsPerUnit * thresholds.high, true);
  return edges;
}

/// Takes out the contours that are too short or too faint to be more than noise.
void dropSpecks(const image::EdgeMap& map, double noise, cv::Mat& edges) {
  cv::Mat labels;
  const int count = cv::connectedComponents(edges, labels, 8, CV_32S);
  std::vector<double> sums(static_cast<std::size_t>(count));
  std::vector<int> sizes(sums.size());
  std::size_t i = 0;
  for (int y = 0; y < edges.rows; ++y) {
    for (int x = 0; x < edges.cols; ++x, ++i) {
      const std::size_t label = static_cast<std::size_t>(labels.at<int>(y, x));
      if (label == 0) continue;
      sums[label] +=
          std::sqrt(map.gradientX[i] * map.gradientX[i] + map.gradientY[i] * map.gradientY[i]);
      ++sizes[label];
    }
  }
  for (int y = 0; y < edges.rows; ++y) {
    for (int x = 0; x < edges.cols; ++x) {
      const std::size_t label = static_cast<std::size_t>(labels.at<int>(y, x));
      if (label > 0 && !isContour(sums[label], sizes[label], noise))
        edges.at<std::uint8_t>(y, x) = 0;
    }
  }
}

void proximityPlane(const cv::Mat& edges, image::EdgeMap& map) {
  cv::Mat away, distance;
  cv::bitwise_not(edges, away);
  cv::distanceTransform(away, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE, CV_32F);
  const bool any = cv::countNonZero(edges) > 0;
  map.proximity.resize(map.edges.size());
  std::size_t i = 0;
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x, ++i) {
      const double near = 1 - distance.at<float>(y, x) / map.reach;
      map.proximity[i] = any && near > 0 ? static_cast<float>(near) : 0.0f;
    }
  }
}

template <class Out>
void copyRows(const cv::Mat& from, std::vector<Out>& to) {
  const std::size_t row =
      static_cast<std::size_t>(from.cols) * static_cast<std::size_t>(from.channels());
  to.resize(row * static_cast<std::size_t>(from.rows));
  for (int y = 0; y < from.rows; ++y) {
    std::copy_n(from.ptr<Out>(y), row, to.data() + row * static_cast<std::size_t>(y));
  }
}

Result<image::EdgeMap> searchEdges(const image::Picture& picture, const EdgeParams& params,
                                   const Progress& progress) {
  const image::Image& working = picture.working;
  const image::Size size =
      image::fitSize({working.width, working.height}, kWorkingPixels, params.longSide);
  const image::Image copy = image::shrink(working, size.width, size.height);
  if (copy.empty()) return Error::PictureEmpty;
  if (!progress.advance(0.15)) return Error::Cancelled;

  image::EdgeMap map;
  map.width = size.width;
  map.height = size.height;
  map.scaleX = static_cast<double>(picture.width) / size.width;
  map.scaleY = static_cast<double>(picture.height) / size.height;
  map.reach = std::max(kShortestReach, params.reachShare * size.width);
  const cv::Mat lab = smoothLab(copy, params.blurSigma);
  copyRows(lab, map.lab);
  if (!progress.advance(0.45)) return Error::Cancelled;

  gradientPlanes(lab, map);
  if (!progress.advance(0.7)) return Error::Cancelled;

  const Thresholds thresholds = chooseThresholds(map.gradientX, map.gradientY);
  cv::Mat edges = cannyEdges(map, thresholds);
  dropSpecks(map, thresholds.noise, edges);
  copyRows(edges, map.edges);
  if (!progress.advance(0.85)) return Error::Cancelled;

  proximityPlane(edges, map);
  if (!progress.advance(1)) return Error::Cancelled;
  return map;
}

}  // namespace

Result<image::EdgeMap> detectEdges(const image::Picture& picture, const EdgeParams& params,
                                   const Progress& progress) {
  if (picture.working.empty() || picture.width <= 0 || picture.height <= 0) {
    return Error::PictureEmpty;
  }
  if (std::min(picture.width, picture.height) < kMinPictureSide) return Error::PictureTooSmall;
  if (!inRange(params)) return Error::ValueOutOfRange;
  if (!progress.advance(0)) return Error::Cancelled;
  try {
    useOneThread();
    return searchEdges(picture, params, progress);
  } catch (const cv::Exception& problem) {
    // OpenCV is only given sizes that it can take, so what is left is memory.
    return {Error::OutOfMemory, problem.err};
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

}  // namespace spineloft::vision
