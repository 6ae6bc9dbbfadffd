#include "engine/inflate/thin_rings.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "engine/geometry/polygon.h"
#include "engine/geometry/polyline.h"
#include "engine/inflate/crossing.h"

namespace spineloft::inflate {
namespace {

using Curve = std::vector<SectionPoint>;

constexpr double kSame = 1e-9;  // pixels

/// Pixels of a unit of s and of one of z, where the region is widest.
SectionPoint unitsOf(std::span<const EditedSkeleton> bones, double side, const InflateParams& params) {
  double widest = 0;
  for (const EditedSkeleton& piece : bones) {
    for (const SkeletonPoint& point : piece.skeleton.points) widest = std::max(widest, point.radius);
  }
  if (params.profile.across == Across::Length) widest = std::min(widest, params.profile.reach * side);
  return {widest, widest * params.height};
}

/// A counter-clockwise curve whose every edge lies so much farther out; corners no farther than kMitre times that.
Curve grown(const Curve& curve, double by) {
  constexpr double kMitre = 2;
  const std::size_t n = curve.size();
  const auto outwards = [&](std::size_t i) {  // of the edge from point i
    const SectionPoint way = curve[(i + 1) % n] - curve[i % n];
    return SectionPoint{way.y, -way.x} / norm(way);
  };
  Curve out;
  for (std::size_t i = 0; i < n; ++i) {
    const SectionPoint before = outwards(i + n - 1), after = outwards(i), both = before + after;
    const double share = std::max(dot(both, both), 4 / (kMitre * kMitre));
    out.push_back(curve[i] + both * (2 * by / share));
  }
  return out;
}

/// Whether a closed curve goes through itself or through one of the others.
bool meets(const Curve& ring, std::span<const std::vector<ProfileCurve>> all, std::size_t own, std::size_t slice) {
  if (!geometry::isSimple(ring)) return true;
  const std::size_t n = ring.size();
  for (std::size_t c = 0; c < all.size(); ++c) {
    if (c == own) continue;
    const auto& [points, closed] = all[c][slice];
    for (std::size_t k = closed ? 0 : 1; k < points.size(); ++k) {
      const SectionPoint from = points[(k + points.size() - 1) % points.size()], to = points[k];
      for (std::size_t i = 0; i < n; ++i) {
        if (crossing(ring[i], ring[(i + 1) % n], from, to)) return true;
      }
    }
  }
  return false;
}

/// A closed curve about a solid that is thinner than `least` pixels, so thick; none for others.
std::optional<Curve> thickened(const ProfileCurve& ring, SectionPoint units, double least) {
  if (!ring.closed) return std::nullopt;
  Curve curve;
  double length = 0;
  for (const SectionPoint p : ring.points) curve.push_back({p.x * units.x, p.y * units.y});
  curve = geometry::dropRepeats(std::span<const SectionPoint>(curve), kSame);
  const auto [low, high] = std::ranges::minmax(curve, {}, &SectionPoint::y);
  for (std::size_t i = 0; i < curve.size(); ++i) length += distance(curve[i], curve[(i + 1) % curve.size()]);
  const double thick = 2 * geometry::signedArea(std::span<const SectionPoint>(curve)) / length;
  if (thick <= 0 || thick >= least) return std::nullopt;
  curve = grown(curve, (least - thick) / 2);
  const auto [inner, outer] = std::ranges::minmax(curve, {}, &SectionPoint::x);
  const double in = std::max(0.0, outer.x - units.x), out = std::max(0.0, kNearAxis * units.x - inner.x);
  const auto [below, above] = std::ranges::minmax(curve, {}, &SectionPoint::y);
  double up = 0;  // what lies on one side of the plane stays there
  if (low.y >= 0) up = std::max(0.0, -below.y);
  if (high.y <= 0) up = std::min(0.0, -above.y);
  for (SectionPoint& p : curve) p = {(p.x + out - in) / units.x, (p.y + up) / units.y};
  return curve;
}

}  // namespace

int thickenRings(MatchedCurves& curves, std::span<const EditedSkeleton> bones, image::Size picture,
                 const InflateParams& params) {
  const double side = std::max(picture.width, picture.height);
  const SectionPoint units = unitsOf(bones, side, params);
  int count = 0;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    for (std::size_t slice = 0; slice < curves[c].size(); ++slice) {
      std::optional<Curve> ring = thickened(curves[c][slice], units, kLeastRing * side);
      if (!ring || meets(*ring, curves, c, slice)) continue;
      curves[c][slice].points = *std::move(ring);
      ++count;
    }
  }
  return count;
}

int thinRings(std::span<const EditedSkeleton> bones, image::Size picture, const InflateParams& params) {
  Result<MatchedCurves> curves = matchedCurves(params.profile.slices, params.sides);
  return curves ? thickenRings(curves.value(), bones, picture, params) : 0;
}

}  // namespace spineloft::inflate
