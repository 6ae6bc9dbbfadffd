#include "engine/geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace spineloft::geometry {
namespace {

/// > 0 when c lies left of a→b.
double side(SectionPoint a, SectionPoint b, SectionPoint c) { return cross(b - a, c - a); }

/// c is on the line through a and b: is it between them?
bool between(SectionPoint a, SectionPoint b, SectionPoint c) {
  return std::min(a.x, b.x) <= c.x && c.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= c.y &&
         c.y <= std::max(a.y, b.y);
}

bool touch(SectionPoint a, SectionPoint b, SectionPoint c, SectionPoint d) {
  const double ac = side(a, b, c), ad = side(a, b, d), ca = side(c, d, a), cb = side(c, d, b);
  if (((ac > 0 && ad < 0) || (ac < 0 && ad > 0)) && ((ca > 0 && cb < 0) || (ca < 0 && cb > 0))) {
    return true;
  }
  return (ac == 0 && between(a, b, c)) || (ad == 0 && between(a, b, d)) ||
         (ca == 0 && between(c, d, a)) || (cb == 0 && between(c, d, b));
}

/// Neighbours a→b→c fold back onto each other.
bool foldsBack(SectionPoint a, SectionPoint b, SectionPoint c) {
  return side(a, b, c) == 0 && dot(b - a, c - b) < 0;
}

}  // namespace

SectionPoint centroid(std::span<const SectionPoint> polygon) {
  SectionPoint mean, weighted;
  double total = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    mean += polygon[i];
    if (i == 0 || i + 1 == polygon.size()) continue;
    const SectionPoint a = polygon[i] - polygon[0], b = polygon[i + 1] - polygon[0];
    const double twice = cross(a, b);
    total += twice;
    weighted += (a + b) * (twice / 3);
  }
  if (total == 0) return mean / static_cast<double>(polygon.size());
  return polygon[0] + weighted / total;
}

bool isSimple(std::span<const SectionPoint> polygon) {
  const std::size_t n = polygon.size();
  if (n < 3) return false;
  struct Edge {
    double low, high;
    std::size_t at;
  };
  std::vector<Edge> edges(n);
  for (std::size_t i = 0; i < n; ++i) {
    const SectionPoint a = polygon[i], b = polygon[(i + 1) % n];
    if (!isFinite(a) || a == b || foldsBack(a, b, polygon[(i + 2) % n])) return false;
    edges[i] = {std::min(a.x, b.x), std::max(a.x, b.x), i};
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.low < b.low; });
  std::vector<Edge> active;
  for (const Edge& edge : edges) {
    std::erase_if(active, [&](const Edge& other) { return other.high < edge.low; });
    for (const Edge& other : active) {
      const std::size_t gap = edge.at > other.at ? edge.at - other.at : other.at - edge.at;
      if (gap == 1 || gap == n - 1) continue;
      if (touch(polygon[edge.at], polygon[(edge.at + 1) % n], polygon[other.at],
                polygon[(other.at + 1) % n])) {
        return false;
      }
    }
    active.push_back(edge);
  }
  return true;
}

bool seesAllEdges(std::span<const SectionPoint> polygon, SectionPoint p, double margin) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const SectionPoint a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    if (!(side(a, b, p) >= margin * distance(a, b)) || a == b) return false;
  }
  return polygon.size() >= 3;
}

}  // namespace spineloft::geometry
