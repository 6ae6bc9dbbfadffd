#include "engine/geometry/ridge.h"

#include <algorithm>
#include <cmath>

namespace spineloft::geometry {
namespace {

/// A corner of the rim seen from inside.
struct Corner {
  SectionPoint at;
  SectionPoint in, out;  ///< unit normals of its two sides, into the region
  double turn = 0;       ///< radians, positive where the region is convex
  /// The way on which both sides grow farther, by one a unit.
  SectionPoint middle() const {
    constexpr double kLeast = 0.02;
    const SectionPoint sum = normalized(in + out);
    return turn > 0 ? sum / std::max(kLeast, dot(sum, in)) : sum;
  }
};

Corner cornerOf(std::span<const SectionPoint> polygon, std::size_t i) {
  const std::size_t size = polygon.size();
  const SectionPoint before = normalized(polygon[i] - polygon[(i + size - 1) % size]);
  const SectionPoint after = normalized(polygon[(i + 1) % size] - polygon[i]);
  return {polygon[i], {-before.y, before.x}, {-after.y, after.x}, std::atan2(cross(before, after), dot(before, after))};
}

/// How far a point may go from the corner along its middle until another side is nearer, at most
/// `most`.
double reachOf(const Corner& corner, const RimDistance& distances, double most) {
  constexpr double kSlack = 1e-3;
  const SectionPoint middle = corner.middle();
  const auto isOwn = [&](double away) { return distances.to(corner.at + middle * away) >= (1 - kSlack) * away; };
  if (isOwn(most)) return most;
  double low = 0, high = most;
  constexpr int kHalvings = 12;
  for (int k = 0; k < kHalvings; ++k) {
    const double away = (low + high) / 2;
    (isOwn(away) ? low : high) = away;
  }
  return low;
}

/// Whether the side that is nearer beyond `away` leans clearly against the corner's own.
bool isRidge(const Corner& corner, const RimDistance& distances, double away) {
  constexpr double kOn = 0.1, kLean = 0.8;  // share of away; cosine
  const SectionPoint middle = corner.middle();
  const double here = distances.to(corner.at + middle * away);
  return distances.to(corner.at + middle * (away * (1 + kOn))) - here < kLean * kOn * away;
}

/// Points round a corner that points inwards, a few at every row.
void addArcs(const Corner& corner, const RimDistance& distances, std::span<const double> rows,
             std::vector<SectionPoint>& points) {
  constexpr double kStep = 0.4;  // radians
  const int steps = static_cast<int>(std::ceil(-corner.turn / kStep));
  for (const double away : rows) {
    for (int k = 0; k <= steps; ++k) {
      const double angle = corner.turn * k / steps, c = std::cos(angle), s = std::sin(angle);
      const SectionPoint way{corner.in.x * c - corner.in.y * s, corner.in.x * s + corner.in.y * c};
      const SectionPoint p = corner.at + way * away;
      constexpr double kSlack = 1e-3;
      if (distances.to(p) >= (1 - kSlack) * away) points.push_back(p);
    }
  }
}

}  // namespace

std::vector<SectionPoint> ridgePoints(std::span<const SectionPoint> rim, std::span<const std::size_t> sizes,
                                      const RimDistance& distances, const RidgeWish& wish) {
  std::vector<SectionPoint> points;
  std::size_t first = 0;
  for (const std::size_t size : sizes) {
    for (std::size_t i = 0; i < size; ++i) {
      const Corner corner = cornerOf(rim.subspan(first, size), i);
      if (corner.turn < -kSharpTurn) {
        addArcs(corner, distances, wish.rows, points);
        continue;
      }
      const double most = reachOf(corner, distances, wish.reach);
      const SectionPoint middle = corner.middle();
      if (corner.turn > kSharpTurn) {
        const double step = wish.spacing / std::max(1.0, norm(middle));
        for (double away = step; away < most - step / 2; away += step) {
          points.push_back(corner.at + middle * away);
        }
        points.push_back(corner.at + middle * most);
      } else if (most < wish.reach && isRidge(corner, distances, most)) {
        points.push_back(corner.at + middle * most);
      }
    }
    first += size;
  }
  return points;
}

void flipToSurface(PlaneMesh& mesh, const std::function<double(SectionPoint)>& height, double top, double tolerance) {
  std::vector<double> heights;
  for (const SectionPoint p : mesh.points()) heights.push_back(height(p));
  const auto off = [&](std::uint32_t a, std::uint32_t b) {
    const SectionPoint middle = (mesh.points()[a] + mesh.points()[b]) / 2;
    return std::abs(height(middle) - (heights[a] + heights[b]) / 2);
  };
  const auto at = [&](std::uint32_t p) {
    return Vec3<SectionSpace>{mesh.points()[p].x, mesh.points()[p].y, heights[p]};
  };
  // Height over longest side of a triangle on the surface.
  const auto shape = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto pa = at(a), pb = at(b), pc = at(c);
    const double longest = std::max({dot(pb - pa, pb - pa), dot(pc - pb, pc - pb), dot(pa - pc, pa - pc)});
    return longest > 0 ? norm(cross(pb - pa, pc - pa)) / longest : 0;
  };
  constexpr int kRounds = 3;
  constexpr double kLeastShape = 0.1;
  mesh.flipWhere(
      [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        if (std::min({heights[a], heights[b], heights[c], heights[d]}) >= top) return false;
        const std::uint32_t rim = static_cast<std::uint32_t>(mesh.rim());
        if (c < rim && d < rim) return false;  // would be a chord, where both sides meet
        const double now = off(a, b);
        if (now <= tolerance || off(c, d) + tolerance >= now) return false;
        const double made = std::min(shape(c, d, a), shape(d, c, b));
        return made >= kLeastShape || made >= std::min(shape(a, b, c), shape(b, a, d));
      },
      kRounds);
}

}  // namespace spineloft::geometry
