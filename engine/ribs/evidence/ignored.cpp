#include "engine/ribs/evidence/ignored.h"

#include <algorithm>
#include <cmath>

#include "engine/geometry/polyline.h"

namespace spineloft::ribs {
namespace {

// Points of a mark closer than this share of its radius are one: its rim moves by less than a
// hundredth of the radius.
constexpr double kSameShare = 0.1;

// Map pixels with lowX ≤ x ≤ highX and lowY ≤ y ≤ highY; empty where low > high.
struct Window {
  int lowX, lowY, highX, highY;
};

Window clipped(double lowX, double lowY, double highX, double highY, const image::EdgeMap& map) {
  const auto at = [](double value, int last) {
    return static_cast<int>(std::clamp(value, -1.0, static_cast<double>(last) + 1));
  };
  return {std::max(0, at(std::floor(lowX), map.width)), std::max(0, at(std::floor(lowY), map.height)),
          std::min(map.width - 1, at(std::ceil(highX), map.width)),
          std::min(map.height - 1, at(std::ceil(highY), map.height))};
}

std::size_t pixelOf(const image::EdgeMap& map, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) + static_cast<std::size_t>(x);
}

void fillAround(PicturePoint a, PicturePoint b, double radius, const image::EdgeMap& map,
                std::vector<std::uint8_t>& mask) {
  const auto low = map.toMap({std::min(a.x, b.x) - radius, std::min(a.y, b.y) - radius});
  const auto high = map.toMap({std::max(a.x, b.x) + radius, std::max(a.y, b.y) + radius});
  const Window w = clipped(low.x, low.y, high.x, high.y, map);
  const PicturePoint u = b - a;
  const double squared = dot(u, u);
  for (int y = w.lowY; y <= w.highY; ++y) {
    for (int x = w.lowX; x <= w.highX; ++x) {
      const PicturePoint p{(x + 0.5) * map.scaleX - 0.5, (y + 0.5) * map.scaleY - 0.5};
      const double t = squared > 0 ? std::clamp(dot(p - a, u) / squared, 0.0, 1.0) : 0;
      const PicturePoint away = p - (a + u * t);
      if (dot(away, away) <= radius * radius) mask[pixelOf(map, x, y)] = 255;
    }
  }
}

bool isUsable(const IgnoreMark& mark) {
  return !mark.stroke.empty() && mark.radius > 0 && std::isfinite(mark.radius) &&
         std::ranges::all_of(mark.stroke, [](PicturePoint p) { return isFinite(p); });
}

void fillMark(const IgnoreMark& mark, const image::EdgeMap& map, std::vector<std::uint8_t>& mask) {
  auto points = geometry::dropRepeats(std::span<const PicturePoint>(mark.stroke), kSameShare * mark.radius);
  points.push_back(mark.stroke.back());
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    fillAround(points[i], points[i + 1], mark.radius, map, mask);
  }
}

// Calls visit(pixel, nearness) for every pixel within the map's reach of (x, y).
template <class Visit>
void aroundEdge(const image::EdgeMap& map, int x, int y, const Visit& visit) {
  const double reach = map.reach;
  const Window w = clipped(x - reach, y - reach, x + reach, y + reach, map);
  for (int j = w.lowY; j <= w.highY; ++j) {
    for (int i = w.lowX; i <= w.highX; ++i) {
      const double away = std::sqrt(static_cast<double>((i - x) * (i - x) + (j - y) * (j - y)));
      if (away < reach) visit(pixelOf(map, i, j), static_cast<float>(1 - away / reach));
    }
  }
}

// Takes back what edges under the mask gave, and gives it again from the others.
void renewProximity(const image::EdgeMap& map, IgnoredEdges& ignored) {
  std::vector<std::uint8_t> stale(ignored.mask.size(), 0);
  Window all{map.width, map.height, -1, -1};
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const std::size_t at = pixelOf(map, x, y);
      if (!ignored.mask[at] || !map.edges[at]) continue;
      all = {std::min(all.lowX, x), std::min(all.lowY, y), std::max(all.highX, x), std::max(all.highY, y)};
      aroundEdge(map, x, y, [&](std::size_t pixel, float) {
        stale[pixel] = 1;
        ignored.proximity[pixel] = 0;
      });
    }
  }
  if (all.highX < 0) return;
  // The others that reach a stale pixel stand within twice the reach of an edge under the mask.
  const double far = 2 * map.reach;
  const Window w = clipped(all.lowX - far, all.lowY - far, all.highX + far, all.highY + far, map);
  for (int y = w.lowY; y <= w.highY; ++y) {
    for (int x = w.lowX; x <= w.highX; ++x) {
      const std::size_t at = pixelOf(map, x, y);
      if (ignored.mask[at] || !map.edges[at]) continue;
      aroundEdge(map, x, y, [&](std::size_t pixel, float nearness) {
        if (stale[pixel]) ignored.proximity[pixel] = std::max(ignored.proximity[pixel], nearness);
      });
    }
  }
}

}  // namespace

IgnoredEdges ignoreEdges(const image::EdgeMap& edges, std::span<const IgnoreMark> ofPicture,
                         std::span<const IgnoreMark> ofPart) {
  IgnoredEdges ignored;
  if (edges.empty()) return ignored;
  for (const auto marks : {ofPicture, ofPart}) {
    for (const IgnoreMark& mark : marks) {
      if (!isUsable(mark)) continue;
      if (ignored.mask.empty()) ignored.mask.assign(edges.edges.size(), 0);
      fillMark(mark, edges, ignored.mask);
    }
  }
  if (ignored.empty()) return ignored;
  ignored.proximity.reserve(edges.look.size());
  for (std::size_t i = 0; i < edges.look.size(); ++i) ignored.proximity.push_back(edges.nearness(i));
  renewProximity(edges, ignored);
  return ignored;
}

}  // namespace spineloft::ribs
