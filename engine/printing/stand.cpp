#include "engine/printing/stand.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/printing/triangle.h"

namespace spineloft::printing {
namespace {

constexpr int kFootSteps = 30;
/// A part keeps at least this share of its height.
constexpr double kLeastKept = 0.3;

/// The convex hull, counter-clockwise (Andrew's monotone chain).
std::vector<GroundPoint> hullOf(std::vector<GroundPoint> points) {
  std::ranges::sort(points,
                    [](const GroundPoint& a, const GroundPoint& b) { return a.x != b.x ? a.x < b.x : a.z < b.z; });
  const auto turns = [](const GroundPoint& o, const GroundPoint& a, const GroundPoint& b) {
    return (a.x - o.x) * (b.z - o.z) - (a.z - o.z) * (b.x - o.x);
  };
  std::vector<GroundPoint> hull;
  const auto chain = [&](auto first, auto last) {
    const std::size_t base = hull.size();
    for (auto p = first; p != last; ++p) {
      while (hull.size() >= base + 2 && turns(hull[hull.size() - 2], hull.back(), *p) <= 0) hull.pop_back();
      hull.push_back(*p);
    }
    if (!hull.empty()) hull.pop_back();  // the next chain begins with it
  };
  chain(points.begin(), points.end());
  chain(points.rbegin(), points.rend());
  return hull;
}

/// Distance from the inside of the hull's nearest edge; negative outside, and without an area.
double inside(const std::vector<GroundPoint>& hull, GroundPoint p) {
  if (hull.size() < 3) return -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const GroundPoint &a = hull[i], &b = hull[(i + 1) % hull.size()];
    const double ex = b.x - a.x, ez = b.z - a.z, way = std::hypot(ex, ez);
    if (way > 0) least = std::min(least, (ex * (p.z - a.z) - ez * (p.x - a.x)) / way);
  }
  return least;
}

/// What is left above a level: its volume, the volume times its centre, and where it was cut.
struct Rest {
  double volume = 0;
  Point weighted;
  std::vector<GroundPoint> section;
};

Point crossing(Point a, Point b, double level) {
  const double t = (level - a.y) / (b.y - a.y);
  return {a.x + (b.x - a.x) * t, level, a.z + (b.z - a.z) * t};
}

/// Adds one triangle. The flat cut adds nothing: the tetrahedra stand on a point of it.
void addTriangle(const Corners& corners, double level, Rest& rest) {
  std::array<Point, 4> kept;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point a = corners[i], b = corners[(i + 1) % 3];
    if (a.y >= level) kept[count++] = a;
    if ((a.y >= level) == (b.y >= level)) continue;
    kept[count] = crossing(a, b, level);
    rest.section.push_back({kept[count].x, kept[count].z});
    ++count;
  }
  const Point apex{0, level, 0};
  for (std::size_t i = 2; i < count; ++i) {
    const Point a = kept[0] - apex, b = kept[i - 1] - apex, c = kept[i] - apex;
    const double volume = dot(a, cross(b, c)) / 6;
    rest.volume += volume;
    rest.weighted += (apex * 4 + a + b + c) * (volume / 4);
  }
}

double tippingAngleAt(std::span<const mesh::TriMesh> parts, double level) {
  Rest rest;
  for (const mesh::TriMesh& mesh : parts) {
    for (const auto& t : mesh.triangles) addTriangle(cornersOf(mesh, t), level, rest);
  }
  if (!(rest.volume > 0)) return -1;
  const Point centre = rest.weighted / rest.volume;
  return tippingAngleOf(std::move(rest.section), {centre.x, centre.z}, centre.y - level);
}

struct Reach {
  double low = std::numeric_limits<double>::infinity(), high = -low;
};

}  // namespace

double tippingAngleOf(std::vector<GroundPoint> foot, GroundPoint centre, double height) {
  return std::atan2(inside(hullOf(std::move(foot)), centre), std::max(1e-6, height));
}

std::optional<double> flatFoot(std::span<const mesh::TriMesh> parts) {
  std::vector<Reach> reaches;
  Reach all;
  for (const mesh::TriMesh& mesh : parts) {
    Reach reach;
    for (const auto& p : mesh.positions) {
      reach.low = std::min(reach.low, static_cast<double>(p[1]));
      reach.high = std::max(reach.high, static_cast<double>(p[1]));
    }
    reaches.push_back(reach);
    all = {std::min(all.low, reach.low), std::max(all.high, reach.high)};
  }
  if (!(all.low < all.high)) return std::nullopt;
  for (int k = 1; k <= kFootSteps; ++k) {
    const double foot = kMostFoot * (all.high - all.low) * k / kFootSteps, level = all.low + foot;
    const bool tooMuch = std::ranges::any_of(reaches, [&](const Reach& reach) {
      return reach.low < level && reach.high - level < kLeastKept * (reach.high - reach.low);
    });
    if (tooMuch) return std::nullopt;
    if (tippingAngleAt(parts, level) >= kGoodTippingAngle) return foot;
  }
  return std::nullopt;
}

}  // namespace spineloft::printing
