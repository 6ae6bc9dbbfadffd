#include "engine/descriptive/straight.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/geometry/polyline.h"

namespace spineloft::descriptive {

std::vector<double> cornersOf(const MeasuredLine& line, double size, double turn) {
  std::vector<PicturePoint> points = line.points;
  std::vector<double> s = line.s;
  if (line.closed) {
    // From the point that is farthest from the middle, which is a corner where there is one.
    points.pop_back();
    const PicturePoint middle =
        std::accumulate(points.begin(), points.end(), PicturePoint{}) / static_cast<double>(points.size());
    const auto far = std::ranges::max_element(points, {}, [&](PicturePoint p) { return distance(p, middle); });
    const auto first = far - points.begin();
    std::ranges::rotate(points, far);
    s.pop_back();
    std::ranges::rotate(s, s.begin() + first);
    points.push_back(points.front());
    s.push_back(s.front());
  }
  const std::span<const PicturePoint> all(points);
  std::vector<std::size_t> kept;
  if (line.closed) {
    const auto far = std::ranges::max_element(points, {}, [&](PicturePoint p) { return distance(p, points.front()); });
    const auto half = static_cast<std::size_t>(far - points.begin());
    kept = geometry::keptPoints(all.first(half + 1), 1.2 * kTremor * size);
    const auto rest = geometry::keptPoints(all.subspan(half), 1.2 * kTremor * size);
    for (std::size_t i = 1; i < rest.size(); ++i) kept.push_back(half + rest[i]);
  } else {
    kept = geometry::keptPoints(all, 1.2 * kTremor * size);
  }
  std::vector<double> shares;
  if (!line.closed) shares = {0, 1};
  for (std::size_t i = line.closed ? 0 : 1; i + 1 < kept.size(); ++i) {
    const PicturePoint here = points[kept[i]];
    const PicturePoint in = here - points[i == 0 ? kept[kept.size() - 2] : kept[i - 1]],
                       out = points[kept[i + 1]] - here;
    if (std::abs(std::atan2(cross(in, out), dot(in, out))) > turn) shares.push_back(s[kept[i]] / line.length());
  }
  std::ranges::sort(shares);
  return shares;
}

bool isStraightBetween(const MeasuredLine& line, std::span<const double> shares, double size) {
  const std::size_t n = shares.size();
  if (n < 2) return false;
  for (std::size_t i = 0; i + (line.closed ? 0 : 1) < n; ++i) {
    if (!isStraight(line, shares[i], i + 1 < n ? shares[i + 1] : shares[0] + 1, size)) return false;
  }
  return true;
}

namespace {

constexpr int kLooks = 16;

PicturePoint placeOn(const MeasuredLine& line, double share) { return line.at(share > 1 ? share - 1 : share); }

}  // namespace

bool isStraight(const MeasuredLine& line, double from, double to, double size) {
  const PicturePoint a = placeOn(line, from), b = placeOn(line, to);
  const double most = kEdgeBend * distance(a, b) + kTremor * size;
  for (int k = 1; k < kLooks; ++k) {
    if (geometry::distanceToSegment(placeOn(line, from + (to - from) * k / kLooks), a, b) > most) return false;
  }
  return true;
}

double bowOf(const MeasuredLine& line, double from, double to) {
  const PicturePoint a = placeOn(line, from), chord = placeOn(line, to) - a;
  double sum = 0;
  for (int k = 1; k < kLooks; ++k) sum += cross(chord, placeOn(line, from + (to - from) * k / kLooks) - a);
  return std::abs(sum) / (kLooks * dot(chord, chord));
}

}  // namespace spineloft::descriptive
