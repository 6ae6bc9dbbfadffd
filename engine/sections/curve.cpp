#include "engine/sections/curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "engine/geometry/circle_cubic.h"
#include "engine/geometry/line_distance.h"
#include "engine/geometry/polyline.h"

namespace spineloft::sections {
namespace {

using Cubic = std::array<SectionPoint, 4>;

Cubic cubicOf(const DrawnCurve& curve, std::size_t i, bool open) {
  const std::size_t n = curve.points.size();
  const DrawnPoint& p = curve.points[i];
  const DrawnPoint& q = curve.points[(i + 1) % n];
  const SectionPoint chord = q.at - p.at;
  const auto tangentAt = [&](std::size_t k) {
    if (open && n == 2) return normalized(chord);
    // The circle through the first three points goes from the third to the first and on to the second.
    const std::size_t before = open && k == 0 ? 2 : (k + n - 1) % n;
    const std::size_t after = open && k + 1 == n ? n - 3 : (k + 1) % n;
    return geometry::circleTangent(curve.points[before].at, curve.points[k].at, curve.points[after].at);
  };
  const SectionPoint first = p.corner ? normalized(chord) : tangentAt(i);
  const SectionPoint second = q.corner ? normalized(chord) : tangentAt((i + 1) % n);
  return {p.at, p.at + geometry::circleHandle(chord, first), q.at - geometry::circleHandle(chord, second), q.at};
}

/// Halves until flat: the same numbers from either end.
void flatten(const Cubic& c, int depth, std::vector<SectionPoint>& out) {
  const double bend = std::max(norm((c[0] + c[2]) - c[1] * 2), norm((c[1] + c[3]) - c[2] * 2));
  // A cubic is at most ¾ of its largest second difference away from its chord.
  if (depth == 0 || bend * 0.75 <= kOutlineTolerance) {
    out.push_back(c[3]);
    return;
  }
  const auto middle = [](SectionPoint a, SectionPoint b) { return (a + b) * 0.5; };
  const SectionPoint a = middle(c[0], c[1]), b = middle(c[1], c[2]), d = middle(c[2], c[3]);
  const SectionPoint ab = middle(a, b), bd = middle(b, d), at = middle(ab, bd);
  flatten({c[0], a, ab, at}, depth - 1, out);
  flatten({at, bd, d, c[3]}, depth - 1, out);
}

std::vector<SectionPoint> flat(const Cubic& cubic) {
  constexpr int kDeepest = 6;
  std::vector<SectionPoint> out{cubic[0]};
  flatten(cubic, kDeepest, out);
  return out;
}

/// Arc length along a chain, for looking some way ahead and back.
class Way {
 public:
  explicit Way(const Chain& chain) : points_(chain.points), open_(chain.open) {
    if (!open_) points_.push_back(points_.front());
    s_ = geometry::arcLengths(std::span<const SectionPoint>(points_));
  }
  double length() const { return s_.back(); }
  double at(std::size_t i) const { return s_[i]; }
  SectionPoint point(double s) const {
    if (!open_) s = std::fmod(s + length(), length());
    return geometry::pointAt(std::span<const SectionPoint>(points_), std::span<const double>(s_), s);
  }

 private:
  std::vector<SectionPoint> points_;
  std::vector<double> s_;
  bool open_ = false;
};

/// Places of the first copy where the chain turns sharply, with all their images.
std::set<std::size_t> cornersOf(const Chain& chain, const FitParams& params) {
  const Way way(chain);
  const double window = std::min(params.cornerWindow, way.length() / 24);
  const std::size_t steps = chain.length + (chain.alternating ? 1 : 0), n = chain.points.size();
  std::vector<double> turn(n);
  for (std::size_t i = 0; i < n; ++i) {
    if (chain.open && (way.at(i) < window || way.length() - way.at(i) < window)) continue;
    const SectionPoint p = chain.points[i];
    const SectionPoint before = p - way.point(way.at(i) - window);
    const SectionPoint after = way.point(way.at(i) + window) - p;
    turn[i] = std::abs(std::atan2(cross(before, after), dot(before, after)));
  }
  std::set<std::size_t> corners;
  if (chain.open) corners = {0, n - 1};
  for (std::size_t step = 0; step < steps; ++step) {
    const std::size_t i = step % n;
    if (turn[i] < params.cornerAngle) continue;
    const std::vector<std::size_t> images = chain.imagesOf(step);
    bool sharpest = true;
    for (const int side : {-1, 1}) {
      double gone = 0;
      for (std::size_t j = i; gone < window && sharpest;) {
        const std::size_t next = (j + (side > 0 ? 1 : n - 1)) % n;
        gone += distance(chain.points[j], chain.points[next]);
        j = next;
        if (j == i) break;
        if (std::ranges::binary_search(images, j)) continue;
        sharpest = side > 0 ? turn[i] >= turn[j] : turn[i] > turn[j];
      }
    }
    if (sharpest) corners.insert(images.begin(), images.end());
  }
  return corners;
}

void smooth(std::vector<SectionPoint>& points, const std::set<std::size_t>& fixed, int passes) {
  const std::size_t n = points.size();
  std::vector<SectionPoint> next = points;
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t i = 0; i < n; ++i) {
      if (fixed.contains(i)) continue;
      next[i] = ((points[(i + n - 1) % n] + points[(i + 1) % n]) + points[i] * 2) * 0.25;
    }
    points.swap(next);
  }
}

DrawnCurve curveThrough(const Chain& chain, const std::set<std::size_t>& places, const std::set<std::size_t>& corners) {
  DrawnCurve curve;
  for (const std::size_t i : places) curve.points.push_back({chain.points[i], corners.contains(i)});
  return curve;
}

/// The step of the first copy that place `i` is an image of.
std::size_t stepOf(const Chain& chain, std::size_t i) {
  const std::size_t copy = i / chain.length, within = i % chain.length;
  return chain.alternating && copy % 2 == 1 ? chain.length - within : within;
}

}  // namespace

std::vector<SectionPoint> stretchOf(const DrawnCurve& curve, std::size_t i) { return flat(cubicOf(curve, i, false)); }
std::vector<SectionPoint> openStretchOf(const DrawnCurve& curve, std::size_t i) {
  return flat(cubicOf(curve, i, true));
}

std::vector<SectionPoint> outlineOf(const DrawnCurve& curve) {
  std::vector<SectionPoint> out;
  if (curve.points.size() < 3) return out;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const std::vector<SectionPoint> stretch = stretchOf(curve, i);
    out.insert(out.end(), stretch.begin(), stretch.end() - 1);
  }
  return out;
}

DrawnCurve fitCurve(const Chain& drawn, const FitParams& params) {
  constexpr int kRounds = 24;
  Chain chain = drawn;
  const std::set<std::size_t> corners = cornersOf(chain, params);
  smooth(chain.points, corners, params.smoothing);
  std::set<std::size_t> places = corners;
  const auto choose = [&](std::size_t step) {
    for (const std::size_t image : chain.imagesOf(step)) places.insert(image);
  };
  if (chain.points.size() != chain.length || corners.empty()) choose(0);
  if (chain.alternating) choose(chain.length);
  for (std::size_t quarter = 1; places.size() < 4 && quarter < 4; ++quarter) {
    choose(chain.length * quarter / 4);
  }
  for (int round = 0; round < kRounds; ++round) {
    const DrawnCurve curve = curveThrough(chain, places, corners);
    const std::vector<std::size_t> order(places.begin(), places.end());
    std::vector<std::size_t> worst;
    for (std::size_t k = 0; k + (chain.open ? 1 : 0) < order.size(); ++k) {
      const std::vector<SectionPoint> stretch = chain.open ? openStretchOf(curve, k) : stretchOf(curve, k);
      std::size_t end = order[(k + 1) % order.size()], at = 0;
      if (end <= order[k]) end += chain.points.size();
      double most = params.tolerance;
      for (std::size_t i = order[k] + 1; i < end; ++i) {
        const double off =
            geometry::distanceToLine(chain.points[i % chain.points.size()], std::span<const SectionPoint>(stretch));
        if (off > most) {
          most = off;
          at = i % chain.points.size() + 1;
        }
      }
      if (at > 0) worst.push_back(at - 1);
    }
    if (worst.empty() || places.size() >= kMostCurvePoints) return curve;
    for (const std::size_t place : worst) choose(stepOf(chain, place));
  }
  return curveThrough(chain, places, corners);
}

}  // namespace spineloft::sections
