#include "engine/ribs/base/spine.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "engine/base/limits.h"
#include "engine/geometry/polyline.h"
#include "engine/geometry/stroke_line.h"

namespace spineloft::ribs {
namespace {

using Points = std::vector<PicturePoint>;

// A crossing that leaves more than this share of the stroke on either side of it is a loop.
constexpr double kHookShare = 0.15;
// Hooks that are removed before the stroke is called looped.
constexpr int kMaxHooks = 8;

bool inRange(const SpineParams& p) {
  return p.ribs >= 2 && p.ribs <= 800 && p.minSpacing >= 0.1 && p.minSpacing <= 100 && p.smoothness >= 0 &&
         p.smoothness <= 0.2;
}

// The part of a→b inside the picture's frame, as shares of the segment (Liang–Barsky).
bool clip(PicturePoint a, PicturePoint b, image::Size picture, double& from, double& to) {
  const PicturePoint u = b - a;
  const double p[4] = {-u.x, u.x, -u.y, u.y};
  const double q[4] = {a.x + 0.5, picture.width - 0.5 - a.x, a.y + 0.5, picture.height - 0.5 - a.y};
  from = 0;
  to = 1;
  for (int k = 0; k < 4; ++k) {
    if (p[k] == 0) {
      if (q[k] < 0) return false;
      continue;
    }
    const double t = q[k] / p[k];
    if (p[k] < 0) {
      from = std::max(from, t);
    } else {
      to = std::min(to, t);
    }
  }
  return from <= to;
}

// Leaves the longest run of the stroke inside the picture; nothing when it never is.
void keepLongestInside(Points& stroke, image::Size picture, SpineMemory& memory) {
  Points &best = memory.line.spare, &run = memory.run;
  best.clear();
  run.clear();
  double bestLength = 0, length = 0;
  const auto finish = [&] {
    if (length > bestLength) {
      best.swap(run);
      bestLength = length;
    }
    run.clear();
    length = 0;
  };
  for (std::size_t i = 0; i + 1 < stroke.size(); ++i) {
    double from = 0, to = 1;
    if (!clip(stroke[i], stroke[i + 1], picture, from, to)) {
      finish();
      continue;
    }
    if (from > 0) finish();
    const PicturePoint a = lerp(stroke[i], stroke[i + 1], from);
    const PicturePoint b = to < 1 ? lerp(stroke[i], stroke[i + 1], to) : stroke[i + 1];
    if (run.empty()) run.push_back(a);
    run.push_back(b);
    length += distance(a, b);
    if (to < 1) finish();
  }
  finish();
  stroke.swap(best);
}

// Cuts off short ends that cross the rest of the stroke; false when a real loop remains.
bool removeHooks(Points& points, std::vector<double>& s) {
  for (int round = 0; round <= kMaxHooks; ++round) {
    const auto crossing = geometry::findCrossing(points);
    if (!crossing) return true;
    geometry::arcLengths(std::span<const PicturePoint>(points), s);
    const double head = s[crossing->second] + distance(points[crossing->second], crossing->at);
    const double tail = s.back() - s[crossing->first] - distance(points[crossing->first], crossing->at);
    if (std::min(head, tail) > kHookShare * s.back()) return false;
    if (head <= tail) {
      points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(crossing->second) + 1);
    } else {
      points.resize(crossing->first + 1);
    }
    if (points.size() < 2) return false;
  }
  return false;
}

}  // namespace

Status cleanSpine(std::span<const PicturePoint> stroke, image::Size picture, const SpineParams& params,
                  SpineMemory& memory, Spine& spine) {
  if (!inRange(params)) return Error::ValueOutOfRange;
  if (!std::ranges::all_of(stroke, [](PicturePoint p) { return isFinite(p); })) {
    return Error::StrokeNotFinite;
  }
  if (stroke.empty()) return Error::StrokeTooShort;
  Points& points = memory.points;
  // They change places: what one has room for, all have.
  const std::size_t room = std::bit_ceil(std::max(stroke.size(), geometry::kStrokePoints));
  for (Points* line : {&points, &memory.run, &memory.line.spare}) line->reserve(room);
  points.assign(stroke.begin(), stroke.end());
  const bool forwards = geometry::readsForwards(points);
  if (!forwards) std::ranges::reverse(points);
  geometry::dropRepeats(points, kSamePoint);
  if (points.size() < 2) return Error::StrokeTooShort;
  keepLongestInside(points, picture, memory);
  if (points.size() < 2) return Error::StrokeOutsidePicture;

  std::vector<double>& lengths = memory.line.lengths;
  geometry::spreadEvenly(points, geometry::kStrokePoints, memory.line);
  if (!removeHooks(points, lengths)) return Error::StrokeLoops;
  geometry::spreadEvenly(points, geometry::kStrokePoints, memory.line);
  geometry::smoothWobble(points, params.smoothness, memory.line);
  if (!removeHooks(points, lengths)) return Error::StrokeLoops;

  const double length = geometry::lengthOf(points);
  if (!(length > kSamePoint)) return Error::StrokeTooShort;
  const double fitting = std::floor(length / params.minSpacing) + 1;
  const int count = std::max(2, static_cast<int>(std::min<double>(params.ribs, fitting)));
  geometry::resample(std::span<const PicturePoint>(points), static_cast<std::size_t>(count), lengths, spine.points);
  for (PicturePoint& p : spine.points) {
    p.x = std::clamp(p.x, -0.5, picture.width - 0.5);
    p.y = std::clamp(p.y, -0.5, picture.height - 0.5);
  }
  if (!forwards) std::ranges::reverse(spine.points);
  return Done{};
}

Result<Spine> cleanSpine(std::span<const PicturePoint> stroke, image::Size picture, const SpineParams& params) {
  SpineMemory memory;
  Spine spine;
  const Status cleaned = cleanSpine(stroke, picture, params, memory, spine);
  if (!cleaned.ok()) return cleaned.failure();
  return spine;
}

}  // namespace spineloft::ribs
