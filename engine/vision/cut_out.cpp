#include "engine/vision/cut_out.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace spineloft::vision {
namespace {

using Contours = std::vector<std::vector<PicturePoint>>;

constexpr int kRounds = 4;
/// Colours this near to the one under a hint (8-bit Lab) may belong to the thing.
constexpr double kNearColour = 22;
/// A hint is a disc of this radius, share of the copy's longer side; around it the thing is likely.
constexpr double kHintRadius = 0.012, kLikelyRadius = 0.09;
/// What is smaller or larger than these shares of the picture is no thing.
constexpr double kLeastShare = 0.0008, kMostShare = 0.92;
/// Holes and pieces below this share of the picture are noise.
constexpr double kNoiseShare = 0.0004;
constexpr int kSmoothing = 3;  ///< steps of an outline on either side that smooth it

/// The copy that is cut, and how many original pixels one of its pixels is.
struct Copy {
  cv::Mat bgr;
  double scaleX = 1, scaleY = 1;
  cv::Point at(PicturePoint p) const {
    return {static_cast<int>(std::lround((p.x + 0.5) / scaleX - 0.5)),
            static_cast<int>(std::lround((p.y + 0.5) / scaleY - 0.5))};
  }
  bool holds(cv::Point p) const {
    return p.x >= 0 && p.y >= 0 && p.x < bgr.cols && p.y < bgr.rows;
  }
  PicturePoint back(double x, double y) const {
    return {(x + 0.5) * scaleX - 0.5, (y + 0.5) * scaleY - 0.5};
  }
};

Copy copyOf(const image::Picture& picture) {
  const image::Image& working = picture.working;
  const double shrink =
      std::min(1.0, static_cast<double>(kCutSide) / std::max(working.width, working.height));
  const int width = std::max(2, static_cast<int>(std::lround(working.width * shrink)));
  const int height = std::max(2, static_cast<int>(std::lround(working.height * shrink)));
  const image::Image small = image::shrink(working, width, height);
  Copy copy;
  if (small.empty()) return copy;
  copy.bgr.create(small.height, small.width, CV_8UC3);
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      const std::size_t i =
          4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(small.width) +
               static_cast<std::size_t>(x));
      copy.bgr.at<cv::Vec3b>(y, x) = {small.pixels[i + 2], small.pixels[i + 1], small.pixels[i]};
    }
  }
  copy.scaleX = static_cast<double>(picture.width) / small.width;
  copy.scaleY = static_cast<double>(picture.height) / small.height;
  return copy;
}

/// What is likely before any cut: within the box, or what has the colour under a hint and hangs
/// together with it.
cv::Mat firstGuess(const Copy& copy, const CutHints& hints) {
  const int side = std::max(copy.bgr.cols, copy.bgr.rows);
  cv::Mat mask(copy.bgr.size(), CV_8UC1, cv::Scalar(cv::GC_PR_BGD));
  if (hints.box) {
    mask.setTo(cv::Scalar(cv::GC_BGD));
    const cv::Point a = copy.at(hints.box->low), b = copy.at(hints.box->high);
    const cv::Rect rect = cv::Rect(a, b) & cv::Rect(0, 0, mask.cols, mask.rows);
    mask(rect).setTo(cv::Scalar(cv::GC_PR_FGD));
  }
  cv::Mat lab, calm;
  cv::GaussianBlur(copy.bgr, calm, {}, 1.2);
  cv::cvtColor(calm, lab, cv::COLOR_BGR2Lab);
  for (const PicturePoint hint : hints.inside) {
    const cv::Point at = copy.at(hint);
    if (!copy.holds(at) || hints.box) continue;
    cv::Mat flooded = cv::Mat::zeros(lab.rows + 2, lab.cols + 2, CV_8UC1);
    const cv::Scalar range(kNearColour, kNearColour, kNearColour);
    cv::floodFill(lab, flooded, at, {}, nullptr, range, range,
                  4 | cv::FLOODFILL_MASK_ONLY | cv::FLOODFILL_FIXED_RANGE | (255 << 8));
    mask.setTo(cv::Scalar(cv::GC_PR_FGD), flooded(cv::Rect(1, 1, lab.cols, lab.rows)));
    cv::circle(mask, at, std::max(2, static_cast<int>(kLikelyRadius * side)),
               cv::Scalar(cv::GC_PR_FGD), cv::FILLED);
  }
  const int dot = std::max(1, static_cast<int>(kHintRadius * side));
  for (const PicturePoint hint : hints.inside) {
    if (copy.holds(copy.at(hint))) cv::circle(mask, copy.at(hint), dot, cv::Scalar(cv::GC_FGD), cv::FILLED);
  }
  for (const PicturePoint hint : hints.outside) {
    if (copy.holds(copy.at(hint))) cv::circle(mask, copy.at(hint), dot, cv::Scalar(cv::GC_BGD), cv::FILLED);
  }
  return mask;
}

/// Where the mask says that the thing is, certainly or likely.
cv::Mat thingOf(const cv::Mat& mask) { return (mask & 1) * 255; }

/// The pieces with a hint in them, or the largest; small holes filled.
cv::Mat wantedPieces(const cv::Mat& thing, const Copy& copy, const CutHints& hints) {
  cv::Mat labels, stats, centres;
  const int count = cv::connectedComponentsWithStats(thing, labels, stats, centres, 4, CV_32S);
  cv::Mat wanted = cv::Mat::zeros(thing.size(), CV_8UC1);
  for (const PicturePoint hint : hints.inside) {
    const cv::Point at = copy.at(hint);
    if (!copy.holds(at) || labels.at<int>(at) == 0) continue;
    wanted.setTo(cv::Scalar(255), labels == labels.at<int>(at));
  }
  int largest = 0;
  for (int i = 1; i < count; ++i) {
    const bool more =
        largest == 0 || stats.at<int>(i, cv::CC_STAT_AREA) > stats.at<int>(largest, cv::CC_STAT_AREA);
    if (more) largest = i;
  }
  if (cv::countNonZero(wanted) == 0 && largest > 0) {
    wanted.setTo(cv::Scalar(255), labels == largest);
  }
  return wanted;
}

/// A closed outline of whole pixels with its steps evened out: each point is a mean of those around it.
std::vector<PicturePoint> smoothOutline(const std::vector<cv::Point>& pixels, const Copy& copy) {
  const int count = static_cast<int>(pixels.size());
  std::vector<PicturePoint> outline;
  for (int i = 0; i < count; ++i) {
    double x = 0, y = 0, weights = 0;
    for (int k = -kSmoothing; k <= kSmoothing; ++k) {
      const double weight = kSmoothing + 1 - std::abs(k);
      const cv::Point& p = pixels[static_cast<std::size_t>(((i + k) % count + count) % count)];
      x += weight * p.x;
      y += weight * p.y;
      weights += weight;
    }
    outline.push_back(copy.back(x / weights, y / weights));
  }
  return outline;
}

/// Outlines between pixels: the mask is traced at twice its size, so that the thing keeps its width.
Contours outlinesOf(const cv::Mat& thing, const Copy& copy) {
  cv::Mat large;
  cv::resize(thing, large, {}, 2, 2, cv::INTER_NEAREST);
  cv::copyMakeBorder(large, large, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  std::vector<std::vector<cv::Point>> traced;
  cv::findContours(large, traced, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  Copy fine = copy;
  fine.scaleX /= 2;
  fine.scaleY /= 2;
  Contours contours;
  const double noise = kNoiseShare * static_cast<double>(large.total());
  for (auto& pixels : traced) {
    if (pixels.size() < 8 || cv::contourArea(pixels) < noise) continue;
    for (cv::Point& p : pixels) p -= cv::Point(1, 1);
    contours.push_back(smoothOutline(pixels, fine));
  }
  return contours;
}

bool isUsable(const CutHints& hints, const Copy& copy) {
  const auto onPicture = [&](PicturePoint p) {
    return isFinite(p) && std::abs(p.x) < 1e6 && std::abs(p.y) < 1e6;
  };
  if (!std::ranges::all_of(hints.inside, onPicture) ||
      !std::ranges::all_of(hints.outside, onPicture)) {
    return false;
  }
  if (hints.box) {
    if (!onPicture(hints.box->low) || !onPicture(hints.box->high)) return false;
    const cv::Rect rect = cv::Rect(copy.at(hints.box->low), copy.at(hints.box->high)) &
                          cv::Rect(0, 0, copy.bgr.cols, copy.bgr.rows);
    return rect.width > 2 && rect.height > 2;
  }
  return std::ranges::any_of(hints.inside,
                             [&](PicturePoint p) { return copy.holds(copy.at(p)); });
}

Result<Contours> cut(const image::Picture& picture, const CutHints& hints) {
  if (picture.working.empty()) return Error::PictureEmpty;
  const Copy copy = copyOf(picture);
  if (copy.bgr.empty()) return Error::PictureEmpty;
  if (!isUsable(hints, copy)) return {Error::ValueOutOfRange, "hint"};
  cv::Mat mask = firstGuess(copy, hints);
  const int likely = cv::countNonZero(thingOf(mask));
  if (likely == 0 || likely == static_cast<int>(mask.total())) return Error::NothingCutOut;
  cv::setRNGSeed(1);  // GrabCut begins with k-means, which begins by chance
  cv::Mat inside, outside;
  cv::grabCut(copy.bgr, mask, {}, inside, outside, kRounds, cv::GC_INIT_WITH_MASK);
  cv::Mat thing = wantedPieces(thingOf(mask), copy, hints);
  cv::morphologyEx(thing, thing, cv::MORPH_OPEN, cv::getStructuringElement(cv::MORPH_ELLIPSE, {3, 3}));
  const double share =
      static_cast<double>(cv::countNonZero(thing)) / static_cast<double>(thing.total());
  if (share < kLeastShare || share > kMostShare) return Error::NothingCutOut;
  Contours contours = outlinesOf(thing, copy);
  if (contours.empty()) return Error::NothingCutOut;
  return contours;
}

}  // namespace

Result<Contours> cutOut(const image::Picture& picture, const CutHints& hints) {
  try {
    return cut(picture, hints);
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  } catch (const cv::Exception&) {
    return Error::NothingCutOut;
  }
}

}  // namespace spineloft::vision
