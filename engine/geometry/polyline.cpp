#include "engine/geometry/polyline.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spineloft::geometry {
namespace {

// A symmetric matrix with two off-diagonals either side: row i holds (i,i), (i,i+1), (i,i+2).
using Band = std::vector<std::array<double, 3>>;

// I + weight² DᵀD over the points between the fixed ends; D takes second differences.
void smoothingMatrix(std::size_t unknowns, double weight, Band& band) {
  const double w2 = weight * weight;
  band.assign(unknowns, {1, 0, 0});
  // The second difference centred on point j of the whole polyline touches unknowns j−2, j−1, j.
  const std::array<double, 3> stencil{1, -2, 1};
  for (std::size_t j = 0; j < unknowns; ++j) {
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t b = a; b < 3; ++b) {
        if (j + a < 1 || j + b < 1 || j + a > unknowns || j + b > unknowns) continue;
        band[j + a - 1][b - a] += w2 * stencil[a] * stencil[b];
      }
    }
  }
}

// LDLᵀ in place: row i becomes d_i and the multipliers of rows i+1 and i+2.
void factor(Band& band) {
  const std::size_t n = band.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double d = band[i][0], e = band[i][1], f = band[i][2];
    if (i + 1 < n) {
      band[i + 1][0] -= e * e / d;
      band[i + 1][1] -= e * f / d;
    }
    if (i + 2 < n) band[i + 2][0] -= f * f / d;
    band[i][1] = e / d;
    band[i][2] = f / d;
  }
}

void solve(const Band& band, std::vector<PicturePoint>& x) {
  const std::size_t n = band.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (i + 1 < n) x[i + 1] += x[i] * -band[i][1];
    if (i + 2 < n) x[i + 2] += x[i] * -band[i][2];
  }
  for (std::size_t i = n; i-- > 0;) {
    x[i] = x[i] / band[i][0];
    if (i + 1 < n) x[i] += x[i + 1] * -band[i][1];
    if (i + 2 < n) x[i] += x[i + 2] * -band[i][2];
  }
}

// Where the segments a→b and c→d meet, as shares of the two, if they do.
std::optional<PicturePoint> meet(PicturePoint a, PicturePoint b, PicturePoint c, PicturePoint d) {
  const PicturePoint u = b - a, v = d - c, w = c - a;
  const double area = cross(u, v);
  if (area == 0) return std::nullopt;
  const double s = cross(w, v) / area, t = cross(w, u) / area;
  if (s < 0 || s > 1 || t < 0 || t > 1) return std::nullopt;
  return a + u * s;
}

struct Extent {
  double lowX = std::numeric_limits<double>::infinity(), lowY = lowX, highX = -lowX, highY = -lowX;
  void add(PicturePoint a, PicturePoint b) {
    lowX = std::min({lowX, a.x, b.x});
    highX = std::max({highX, a.x, b.x});
    lowY = std::min({lowY, a.y, b.y});
    highY = std::max({highY, a.y, b.y});
  }
  bool meets(const Extent& o) const { return o.highX >= lowX && o.lowX <= highX && o.highY >= lowY && o.lowY <= highY; }
};

}  // namespace

void smooth(std::vector<PicturePoint>& points, double weight, SmoothMemory& memory) {
  if (points.size() < 3 || !(weight > 0)) return;
  const std::size_t unknowns = points.size() - 2;
  smoothingMatrix(unknowns, weight, memory.band);
  factor(memory.band);
  // Solving for the departure from the chord through both ends makes the right-hand side zero at
  // the fixed ends and keeps a straight line exactly straight.
  const PicturePoint first = points.front(), last = points.back();
  const double steps = static_cast<double>(points.size() - 1);
  std::vector<PicturePoint>& departure = memory.departure;
  departure.resize(unknowns);
  for (std::size_t i = 0; i < unknowns; ++i) {
    departure[i] = points[i + 1] - lerp(first, last, static_cast<double>(i + 1) / steps);
  }
  solve(memory.band, departure);
  for (std::size_t i = 0; i < unknowns; ++i) {
    points[i + 1] = lerp(first, last, static_cast<double>(i + 1) / steps) + departure[i];
  }
}

std::vector<PicturePoint> smooth(std::span<const PicturePoint> points, double weight) {
  std::vector<PicturePoint> out(points.begin(), points.end());
  SmoothMemory memory;
  smooth(out, weight, memory);
  return out;
}

std::optional<Crossing> findCrossing(std::span<const PicturePoint> points) {
  if (points.size() < 4) return std::nullopt;
  const std::size_t segments = points.size() - 1;
  // Boxes of runs of segments: most of the line is not even near to a segment.
  std::array<Extent, 64> boxes;
  const std::size_t run = std::max<std::size_t>(8, (segments + boxes.size() - 1) / boxes.size());
  for (std::size_t j = 0; j < segments; ++j) boxes[j / run].add(points[j], points[j + 1]);
  for (std::size_t i = 0; i + 2 < segments; ++i) {
    const PicturePoint a = points[i], b = points[i + 1];
    Extent own;
    own.add(a, b);
    for (std::size_t j = i + 2; j < segments; ++j) {
      if (!own.meets(boxes[j / run])) {
        j = (j / run + 1) * run - 1;
        continue;
      }
      const PicturePoint c = points[j], d = points[j + 1];
      if (std::max(c.x, d.x) < own.lowX || std::min(c.x, d.x) > own.highX) continue;
      if (std::max(c.y, d.y) < own.lowY || std::min(c.y, d.y) > own.highY) continue;
      if (const auto at = meet(a, b, c, d)) return Crossing{i, j, *at};
    }
  }
  return std::nullopt;
}

}  // namespace spineloft::geometry
