#include "engine/vision/edges.h"

#include <algorithm>
#include <new>

#include "engine/base/limits.h"
#include "engine/vision/colour_gradient.h"
#include "engine/vision/contours.h"
#include "engine/vision/nearness.h"
#include "engine/vision/thresholds.h"

namespace spineloft::vision {
namespace {

/// Shortest ramp, in map pixels, so that tiny pictures still pull towards their edges.
constexpr double kShortestReach = 1.5;

bool inRange(const EdgeParams& params) {
  return params.longSide >= 16 && params.longSide <= 4096 && params.blurSigma >= 0 && params.blurSigma <= 5 &&
         params.reachShare >= 0.001 && params.reachShare <= 0.1;
}

Result<image::EdgeMap> searchEdges(const image::Picture& picture, const EdgeParams& params, const Progress& progress) {
  const image::Image& working = picture.working;
  const image::Size size = image::fitSize({working.width, working.height}, kWorkingPixels, params.longSide);
  const image::Image copy = image::shrink(working, size.width, size.height);
  if (copy.empty()) return Error::PictureEmpty;
  if (!progress.advance(0.15)) return Error::Cancelled;

  image::EdgeMap map;
  map.width = size.width;
  map.height = size.height;
  map.scaleX = static_cast<double>(picture.width) / size.width;
  map.scaleY = static_cast<double>(picture.height) / size.height;
  map.reach = std::max(kShortestReach, params.reachShare * size.width);
  smoothColourAndGradient(copy, params.blurSigma, map);
  if (!progress.advance(0.65)) return Error::Cancelled;

  fillEdges(chooseThresholds(map.gradientX, map.gradientY), map);
  if (!progress.advance(0.9)) return Error::Cancelled;

  fillProximity(map);
  if (!progress.advance(1)) return Error::Cancelled;
  return map;
}

}  // namespace

Result<image::EdgeMap> detectEdges(const image::Picture& picture, const EdgeParams& params, const Progress& progress) {
  if (picture.working.empty() || picture.width <= 0 || picture.height <= 0) {
    return Error::PictureEmpty;
  }
  if (std::min(picture.width, picture.height) < kMinPictureSide) return Error::PictureTooSmall;
  if (!inRange(params)) return Error::ValueOutOfRange;
  if (!progress.advance(0)) return Error::Cancelled;
  try {
    return searchEdges(picture, params, progress);
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

}  // namespace spineloft::vision
