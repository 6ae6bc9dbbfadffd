#include "engine/geometry/steady.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "engine/geometry/polygon.h"
#include "engine/geometry/polyline.h"

namespace spineloft::geometry {
namespace {

constexpr int kTaps = 4;  // to each side of a mean

/// A closed outline by its length.
class Loop {
 public:
  explicit Loop(std::vector<PicturePoint> contour) : points_(std::move(contour)) {
    points_.push_back(points_.front());
    s_ = arcLengths(std::span<const PicturePoint>(points_));
  }
  double length() const { return s_.back(); }
  PicturePoint at(double s) const {
    s = std::fmod(s, length());
    return pointAt(std::span<const PicturePoint>(points_), std::span<const double>(s_), s < 0 ? s + length() : s);
  }
  /// Where the corners are, growing.
  std::vector<double> corners(double reach) const {
    std::vector<std::pair<double, double>> turns;  // how sharp, where
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
      const PicturePoint in = points_[i] - at(s_[i] - reach), out = at(s_[i] + reach) - points_[i];
      const double turn = std::abs(std::atan2(cross(in, out), dot(in, out)));
      if (turn > kSteadyCorner) turns.push_back({turn, s_[i]});
    }
    std::ranges::sort(turns, std::greater{});
    std::vector<double> found;
    for (const auto& [turn, s] : turns) {
      const bool near = std::ranges::any_of(found, [&, here = s](double other) {
        const double apart = std::abs(here - other);
        return std::min(apart, length() - apart) < reach / 2;
      });
      if (!near) found.push_back(s);
    }
    std::ranges::sort(found);
    return found;
  }

 private:
  std::vector<PicturePoint> points_;
  std::vector<double> s_;
};

/// Points about a tap apart all round, and how many taps each may be from a mean's middle.
struct Samples {
  std::vector<PicturePoint> points;
  std::vector<int> taps;
};

Samples sampled(const Loop& loop, double reach) {
  const std::vector<double> corners = loop.corners(reach);
  const bool smooth = corners.empty();
  Samples out;
  for (std::size_t i = 0; i < std::max<std::size_t>(1, corners.size()); ++i) {
    const double from = smooth ? 0 : corners[i];
    const double to = i + 1 < corners.size() ? corners[i + 1] : (smooth ? 0 : corners[0]) + loop.length();
    const int pieces = std::max(1, static_cast<int>(std::round((to - from) * kTaps / reach)));
    for (int k = 0; k < pieces; ++k) {
      out.points.push_back(loop.at(from + (to - from) * k / pieces));
      out.taps.push_back(smooth ? kTaps : std::min({kTaps, k, pieces - k}));
    }
  }
  return out;
}

/// The mean of what is round every point, nearer ones counting more.
std::vector<PicturePoint> means(const std::vector<PicturePoint>& points, const std::vector<int>& taps) {
  const int count = static_cast<int>(points.size());
  std::vector<PicturePoint> out;
  out.reserve(points.size());
  for (int i = 0; i < count; ++i) {
    PicturePoint sum{};
    const int most = taps[static_cast<std::size_t>(i)];
    for (int k = -most; k <= most; ++k) {
      const int at = (i + k + count) % count;
      sum += points[static_cast<std::size_t>(at)] * static_cast<double>(most + 1 - std::abs(k));
    }
    out.push_back(sum / static_cast<double>((most + 1) * (most + 1)));
  }
  return out;
}

std::vector<PicturePoint> steadyLoop(const std::vector<PicturePoint>& contour, const Steadiness& steadiness) {
  const double reach = steadiness.reach;
  const Loop loop(contour);
  constexpr double kLeastReaches = 12, kMostSamples = 1e4;
  if (!(loop.length() > kLeastReaches * reach) || loop.length() * kTaps > kMostSamples * reach) {
    return contour;
  }
  const Samples drawn = sampled(loop, reach);
  // Means draw curves inwards; what a second round would draw them, the first is put back.
  std::vector<PicturePoint> out = means(drawn.points, drawn.taps);
  const std::vector<PicturePoint> twice = means(out, drawn.taps);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const PicturePoint step = out[i] * 2.0 - twice[i] - drawn.points[i];
    const double far = norm(step);
    out[i] = drawn.points[i] + (far > steadiness.most ? step * (steadiness.most / far) : step);
  }
  return out;
}

}  // namespace

Contours steadied(const Contours& contours, const Steadiness& steadiness) {
  Contours out;
  for (const auto& contour : contours) out.push_back(steadyLoop(contour, steadiness));
  const PlaneRegion region = planeRegion(out);
  return areSimple(region.points, region.sizes) ? out : contours;
}

}  // namespace spineloft::geometry
