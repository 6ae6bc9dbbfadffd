#include "engine/geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/geometry/polyline.h"

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
  return (ac == 0 && between(a, b, c)) || (ad == 0 && between(a, b, d)) || (ca == 0 && between(c, d, a)) ||
         (cb == 0 && between(c, d, b));
}

/// Neighbours a→b→c fold back onto each other.
bool foldsBack(SectionPoint a, SectionPoint b, SectionPoint c) { return side(a, b, c) == 0 && dot(b - a, c - b) < 0; }

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

bool areSimple(std::span<const SectionPoint> points, std::span<const std::size_t> sizes) {
  struct Edge {
    SectionPoint a, b;
    double low, high;             // of x
    std::size_t at, first, size;  // its place in its polygon, and which polygon
  };
  std::vector<Edge> edges;
  edges.reserve(points.size());
  std::size_t first = 0;
  for (const std::size_t size : sizes) {
    if (size < 3) return false;
    const std::span<const SectionPoint> polygon = points.subspan(first, size);
    for (std::size_t i = 0; i < size; ++i) {
      const SectionPoint a = polygon[i], b = polygon[(i + 1) % size];
      if (!isFinite(a) || a == b || foldsBack(a, b, polygon[(i + 2) % size])) return false;
      edges.push_back({a, b, std::min(a.x, b.x), std::max(a.x, b.x), i, first, size});
    }
    first += size;
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.low < b.low; });
  const auto neighbours = [](const Edge& a, const Edge& b) {
    if (a.first != b.first) return false;
    const std::size_t gap = a.at > b.at ? a.at - b.at : b.at - a.at;
    return gap == 1 || gap == a.size - 1;
  };
  std::vector<const Edge*> active;
  for (const Edge& edge : edges) {
    std::erase_if(active, [&](const Edge* other) { return other->high < edge.low; });
    for (const Edge* other : active) {
      if (!neighbours(edge, *other) && touch(edge.a, edge.b, other->a, other->b)) return false;
    }
    active.push_back(&edge);
  }
  return true;
}

bool isSimple(std::span<const SectionPoint> polygon) {
  const std::size_t size = polygon.size();
  return areSimple(polygon, {&size, 1});
}

std::optional<SectionPoint> kernelCentre(std::span<const SectionPoint> polygon) {
  if (polygon.size() < 3) return std::nullopt;
  SectionPoint low = polygon[0], high = polygon[0];
  for (const SectionPoint& p : polygon) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  std::vector<SectionPoint> kernel = {low, {high.x, low.y}, high, {low.x, high.y}}, kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const SectionPoint a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    kept.clear();
    for (std::size_t k = 0; k < kernel.size(); ++k) {
      const SectionPoint p = kernel[k], q = kernel[(k + 1) % kernel.size()];
      const double atP = side(a, b, p), atQ = side(a, b, q);
      if (atP >= 0) kept.push_back(p);
      if ((atP > 0 && atQ < 0) || (atP < 0 && atQ > 0)) kept.push_back(lerp(p, q, atP / (atP - atQ)));
    }
    kernel.swap(kept);
    if (kernel.size() < 3) return std::nullopt;
  }
  return centroid(kernel);
}

std::vector<SectionPoint> simplified(std::span<const SectionPoint> polygon, double tolerance) {
  const std::size_t n = polygon.size();
  if (n <= 4) return {polygon.begin(), polygon.end()};
  const auto [left, right] = std::ranges::minmax_element(polygon, {}, &SectionPoint::x);
  const std::size_t a = static_cast<std::size_t>(left - polygon.begin());
  const std::size_t b = static_cast<std::size_t>(right - polygon.begin());
  std::vector<bool> kept(n, false);
  kept[a] = kept[b] = true;
  keepFarther(polygon, {{a, b > a ? b : b + n}, {b, a > b ? a : a + n}}, tolerance, kept);
  std::vector<SectionPoint> out;
  for (std::size_t i = 0; i < n; ++i) {
    if (kept[i]) out.push_back(polygon[i]);
  }
  return out;
}

bool seesAllEdges(std::span<const SectionPoint> polygon, SectionPoint p, double margin) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const SectionPoint a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    if (!(side(a, b, p) >= margin * distance(a, b)) || a == b) return false;
  }
  return polygon.size() >= 3;
}

}  // namespace spineloft::geometry
