#include "engine/vision/nearness.h"

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace spineloft::vision {

void fillProximity(image::EdgeMap& map) {
  map.proximity.assign(map.edges.size(), 0.0f);
  const cv::Mat edges(map.height, map.width, CV_8UC1, map.edges.data());
  if (cv::countNonZero(edges) == 0) return;
  cv::Mat away, distance;
  cv::bitwise_not(edges, away);
  cv::distanceTransform(away, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE, CV_32F);
  float* out = map.proximity.data();
  for (int y = 0; y < map.height; ++y) {
    const float* row = distance.ptr<float>(y);
    for (int x = 0; x < map.width; ++x) {
      *out++ = std::max(0.0f, static_cast<float>(1 - row[x] / map.reach));
    }
  }
}

}  // namespace spineloft::vision
