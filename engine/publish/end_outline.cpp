#include "engine/publish/end_outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>

#include "engine/geometry/polyline.h"
#include "engine/geometry/through_points.h"
#include "engine/ribs/edit/rib_frame.h"

namespace spineloft::publish {
namespace {

/// Of points on rays.
constexpr std::size_t kMostOnRays = 11;
/// Pieces of curves between points.
constexpr std::size_t kSteps = 16;

/// What a loft draws round an end (loft/caps.h).
std::vector<PicturePoint> curveRound(const EndRibs& ribs, const std::vector<PicturePoint>& points) {
  std::vector<PicturePoint> frame{ribs.before.left, ribs.last.left};
  frame.insert(frame.end(), points.begin(), points.end());
  frame.insert(frame.end(), {ribs.last.right, ribs.before.right});
  std::vector<PicturePoint> curve;
  geometry::throughPoints(frame, kSteps, curve);
  return curve;
}

double farthest(std::span<const PicturePoint> of, std::span<const PicturePoint> from) {
  double most = 0;
  for (const PicturePoint p : of) {
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i + 1 < from.size(); ++i)
      least = std::min(least, geometry::distanceToSegment(p, from[i], from[i + 1]));
    most = std::max(most, least);
  }
  return most;
}

/// A curve from the left round to the right in a rib's frame, which is left at one ray after the other.
class Crossings {
 public:
  explicit Crossings(const std::vector<ribs::RibPoint>& curve) : curve_(curve) {}
  /// Where the curve crosses the ray from the middle of the rib, behind the last crossing found.
  std::optional<ribs::RibPoint> next(ribs::RibPoint ray) {
    for (; at_ + 1 < curve_.size(); ++at_) {
      const ribs::RibPoint a = curve_[at_], b = curve_[at_ + 1];
      const double before = cross(ray, a), after = cross(ray, b);
      if (!(before * after <= 0) || before == after) continue;
      const ribs::RibPoint p = lerp(a, b, before / (before - after));
      if (dot(p, ray) > 0) return p;
    }
    return std::nullopt;
  }

 private:
  const std::vector<ribs::RibPoint>& curve_;
  std::size_t at_ = 0;
};

std::optional<std::vector<ribs::RibPoint>> onRays(const std::vector<ribs::RibPoint>& curve, std::size_t count,
                                                  double unit, double step) {
  const auto middle = Crossings(curve).next({1, 0});
  if (!middle) return std::nullopt;
  const double tip = 1 + std::round((middle->x - 1) * unit / step) * step / unit;
  if (!(tip > 0)) return std::nullopt;
  std::vector<ribs::RibPoint> points;
  Crossings crossings(curve);
  for (std::size_t i = 0; i < count; ++i) {
    if (2 * i + 1 == count) {
      if (!crossings.next({1, 0})) return std::nullopt;
      points.push_back({tip, 0});
      continue;
    }
    const auto p = crossings.next(ribs::onEllipse(i, count, tip));
    if (!p) return std::nullopt;
    points.push_back(*p);
  }
  return points;
}

/// So many of the points, evenly, of an odd number with the middle one.
std::vector<ribs::RibPoint> someOf(const std::vector<ribs::RibPoint>& fan, std::size_t count) {
  if (fan.size() <= count) return fan;
  std::vector<ribs::RibPoint> some;
  for (std::size_t i = 1; i <= count; ++i) some.push_back(fan[(2 * i * (fan.size() + 1) / (count + 1) + 1) / 2 - 1]);
  return some;
}

}  // namespace

std::vector<EndOutline> endOutlines(const std::vector<PicturePoint>& found, const EndRibs& foundRibs,
                                    const EndRibs& toldRibs, double step) {
  const ribs::RibFrame frame(toldRibs.last.left, toldRibs.last.right, toldRibs.atStart);
  if (found.empty() || !(frame.unit() >= step / 2)) return {{}};
  const std::vector<ribs::RibPoint> all = frame.fromPicture(found);
  if (!ribs::isValid({.startFan = all})) return {{}};
  // The part ends at the rib where the outline is behind it. A power of two takes the fewest characters.
  const std::vector<ribs::RibPoint> behind{{1 - std::exp2(std::ceil(std::log2(frame.unit() + 1))) / frame.unit(), 0}};
  if (all[all.size() / 2].x <= 0) return {{behind, 0}};

  const std::vector<PicturePoint> wanted = curveRound(foundRibs, found);
  const std::vector<ribs::RibPoint> curve = frame.fromPicture(wanted);
  std::map<std::size_t, EndOutline> byNumbers;
  const auto put = [&](std::size_t numbers, std::vector<ribs::RibPoint> points, const std::vector<PicturePoint>& told) {
    const double off = std::max(farthest(wanted, told), farthest(told, wanted));
    byNumbers.insert({numbers, {std::move(points), off}});
  };
  const auto add = [&](std::size_t numbers, std::vector<ribs::RibPoint> points) {
    const std::vector<PicturePoint> told = curveRound(toldRibs, frame.toPicture(points));
    put(numbers, std::move(points), told);
  };
  put(0, behind, {toldRibs.last.left, toldRibs.last.right});
  for (std::size_t count = 1; count <= kMostOnRays; count += 2) {
    if (auto points = onRays(curve, count, frame.unit(), step)) add(count, *std::move(points));
    if (count < all.size()) add(2 * count, someOf(all, count));
  }
  std::vector<EndOutline> outlines;
  for (auto& [numbers, outline] : byNumbers) {
    outlines.insert(outlines.begin(), std::move(outline));
    if (outlines.front().off <= step) return outlines;
  }
  outlines.insert(outlines.begin(), {all, 0});
  return outlines;
}

}  // namespace spineloft::publish
