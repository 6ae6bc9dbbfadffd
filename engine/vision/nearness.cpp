#include "engine/vision/nearness.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace spineloft::vision {
namespace {

/// Rows to the nearest edge in the same column, at most `far`; from above only.
void distancesFromAbove(const image::EdgeMap& map, std::uint8_t far, std::uint8_t* distance) {
  const std::size_t width = static_cast<std::size_t>(map.width);
  const std::vector<std::uint8_t> outside(width, far);
  const std::uint8_t* above = outside.data();
  const std::uint8_t* edge = map.edges.data();
  for (int y = 0; y < map.height; ++y, edge += width, distance += width) {
    for (std::size_t x = 0; x < width; ++x) {
      const std::uint8_t next = static_cast<std::uint8_t>(above[x] + 1);
      const std::uint8_t capped = next < far ? next : far;
      distance[x] = edge[x] != 0 ? std::uint8_t{0} : capped;
    }
    above = distance;
  }
}

/// The same with those from below.
void addDistanceFromBelow(const std::uint8_t* below, std::size_t width, std::uint8_t* distance) {
  for (std::size_t x = 0; x < width; ++x) {
    const std::uint8_t next = static_cast<std::uint8_t>(below[x] + 1);
    distance[x] = next < distance[x] ? next : distance[x];
  }
}

void squaresOf(const std::uint8_t* distance, std::size_t width, std::int16_t* __restrict squares) {
  for (std::size_t x = 0; x < width; ++x) {
    squares[x] = static_cast<std::int16_t>(distance[x] * distance[x]);
  }
}

/// best = min(best, squares one way or the other + squared), where `squared` is the step's square.
void lookAside(const std::int16_t* left, const std::int16_t* right, std::int16_t squared,
               std::size_t width, std::int16_t* __restrict best) {
  for (std::size_t x = 0; x < width; ++x) {
    const std::int16_t nearer = left[x] < right[x] ? left[x] : right[x];
    const std::int16_t there = static_cast<std::int16_t>(nearer + squared);
    best[x] = there < best[x] ? there : best[x];
  }
}

void rampOf(const std::int16_t* squared, double reach, std::size_t width, float* __restrict ramp) {
  const float slope = static_cast<float>(1 / reach);
  for (std::size_t x = 0; x < width; ++x) {
    const float near = 1 - slope * std::sqrt(static_cast<float>(squared[x]));
    ramp[x] = near > 0 ? near : 0.0f;
  }
}

/// Exact within the reach: first down and up the columns, then along the rows the least sum of
/// squares within the reach (Saito & Toriwaki 1994, cut off).
void scan(image::EdgeMap& map) {
  const std::size_t width = static_cast<std::size_t>(map.width);
  const std::size_t reach = static_cast<std::size_t>(map.reach);
  const std::uint8_t far = static_cast<std::uint8_t>(reach + 1);
  const std::int16_t farSquared = static_cast<std::int16_t>(far * far);
  std::vector<std::uint8_t> rows(map.edges.size());
  distancesFromAbove(map, far, rows.data());
  std::vector<std::int16_t> padded(width + 2 * reach, farSquared), best(width);
  std::int16_t* squares = padded.data() + reach;
  for (int y = map.height - 1; y >= 0; --y) {
    std::uint8_t* row = rows.data() + width * static_cast<std::size_t>(y);
    if (y + 1 < map.height) addDistanceFromBelow(row + width, width, row);
    squaresOf(row, width, squares);
    std::copy_n(squares, width, best.data());
    for (std::size_t k = 1; k <= reach; ++k) {
      lookAside(squares - k, squares + k, static_cast<std::int16_t>(k * k), width, best.data());
    }
    rampOf(best.data(), map.reach, width,
           map.proximity.data() + width * static_cast<std::size_t>(y));
  }
}

/// The same with distances that know no bound.
void transform(image::EdgeMap& map) {
  const cv::Mat edges(map.height, map.width, CV_8UC1, map.edges.data());
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

}  // namespace

void fillProximity(image::EdgeMap& map) {
  map.proximity.assign(map.edges.size(), 0.0f);
  const auto isEdge = [](std::uint8_t value) { return value != 0; };
  if (std::none_of(map.edges.begin(), map.edges.end(), isEdge)) return;
  if (map.reach < kLongestScan) {
    scan(map);
  } else {
    transform(map);
  }
}

}  // namespace spineloft::vision
