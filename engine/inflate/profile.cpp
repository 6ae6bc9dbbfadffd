#include "engine/inflate/profile.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "engine/geometry/axis_clip.h"
#include "engine/geometry/polygon.h"
#include "engine/geometry/polyline.h"
#include "engine/sections/section.h"

namespace spineloft::inflate {
namespace {

using Curve = std::vector<SectionPoint>;
using Curves = std::vector<Curve>;

constexpr int kFine = 256;          ///< points of a preset
constexpr double kOnAxis = 1e-4;    ///< nearer is on it
constexpr double kLopsided = 0.03;  ///< how far the mirror image of a slice may be off it
constexpr double kCorner = 0.4;     ///< radians: sharper turns are corners
constexpr double kSame = 1e-7;

Failure refused(const char* why) { return {Error::SectionInvalid, why}; }

Result<Curves> curvesOf(const sections::SectionShape& shape) {
  if (Status status = sections::checkShape(shape); !status) return status.failure();
  if (!shape.drawn()) {
    Result<sections::Section> section = sections::presetSection(shape.preset, kFine);
    if (!section) return section.failure();
    return Curves{std::move(section).value().points};
  }
  Curves curves;
  for (const Curve& contour : shape.contours) {
    Curve curve = geometry::dropRepeats(std::span<const SectionPoint>(contour), kSame);
    while (curve.size() > 1 && distance(curve.front(), curve.back()) <= kSame) curve.pop_back();
    curves.push_back(std::move(curve));
  }
  return curves;
}

bool isMirrored(const Curves& curves) {
  const auto away = [&](SectionPoint p) {
    double least = INFINITY;
    for (const Curve& curve : curves) {
      for (std::size_t i = 0, j = curve.size() - 1; i < curve.size(); j = i++) {
        least = std::min(least, geometry::distanceToSegment(p, curve[j], curve[i]));
      }
    }
    return least;
  };
  return std::ranges::all_of(curves, [&](const Curve& curve) {
    return std::ranges::all_of(curve, [&](SectionPoint p) { return away({-p.x, p.y}) <= kLopsided; });
  });
}

/// Outer curves counter-clockwise, those in an odd number of others clockwise.
void orient(Curves& curves) {
  for (std::size_t i = 0; i < curves.size(); ++i) {
    bool hole = false;
    for (std::size_t k = 0; k < curves.size(); ++k) {
      if (k != i) hole ^= geometry::holds(std::span<const SectionPoint>(curves[k]), curves[i].front());
    }
    if ((geometry::signedArea(std::span<const SectionPoint>(curves[i])) > 0) == hole) std::ranges::reverse(curves[i]);
  }
}

void swapAxes(Curves& curves) {
  for (Curve& curve : curves) {
    for (SectionPoint& p : curve) std::swap(p.x, p.y);
  }
}
void flip(Curves& curves) {
  for (Curve& curve : curves) {
    for (SectionPoint& p : curve) p.y = -p.y;
    std::ranges::reverse(curve);
  }
}

/// What of the slice lies towards the viewer.
Curves frontOf(Curves curves) {
  swapAxes(curves);
  curves = geometry::clippedAtAxis(curves);
  swapAxes(curves);
  return curves;
}

/// A closed curve at s ≥ 0 without its stretches along the axis. False when it only touches the axis.
bool cutAlongAxis(const Curve& curve, std::vector<ProfileCurve>& out) {
  const std::size_t n = curve.size();
  const auto on = [&](std::size_t i) { return curve[i % n].x == 0; };
  std::size_t start = 0;
  while (start < n && !(on(start) && !on(start + 1))) ++start;
  if (start == n) {
    out.push_back({curve, true});
    return true;
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (on(i) && !on(i + n - 1) && !on(i + 1)) return false;
  }
  ProfileCurve arc;
  for (std::size_t k = start; k <= start + n; ++k) {
    if (on(k) && on(k + 1)) {
      if (arc.points.empty()) continue;
      arc.points.push_back(curve[k % n]);
      out.push_back(std::exchange(arc, {}));
    } else if (k < start + n) {
      arc.points.push_back(curve[k % n]);
    }
  }
  return true;
}

bool isCorner(SectionPoint before, SectionPoint at, SectionPoint after) {
  const SectionPoint in = at - before, out = after - at;
  return std::abs(std::atan2(cross(in, out), dot(in, out))) > kCorner;
}

}  // namespace

Result<std::vector<ProfileCurve>> profileCurves(const sections::SectionShape& shape, InflateSides sides) {
  Result<Curves> read = curvesOf(shape);
  if (!read) return read.failure();
  Curves curves = std::move(read).value();
  for (Curve& curve : curves) {
    for (SectionPoint& p : curve) {
      if (std::abs(p.x) > 1 + kOnAxis) return refused("it reaches beyond x = −1 or x = 1, where the outline is");
      if (std::abs(p.x) < kOnAxis) p.x = 0;
      if (std::abs(p.y) < kOnAxis) p.y = 0;
      p.x = std::clamp(p.x, -1.0, 1.0);
    }
  }
  if (!isMirrored(curves)) return refused("its left half is not the mirror image of its right half");
  orient(curves);
  curves = geometry::clippedAtAxis(curves);
  if (sides == InflateSides::Front) curves = frontOf(std::move(curves));
  if (sides == InflateSides::Back) {
    flip(curves);
    curves = frontOf(std::move(curves));
    flip(curves);
  }
  if (curves.empty()) return refused("nothing of it is on that side");
  std::vector<ProfileCurve> out;
  for (const Curve& curve : curves) {
    if (!cutAlongAxis(curve, out))
      return refused("a curve touches the middle in one point; draw it across or beside it");
  }
  return out;
}

Topology topologyOf(const std::vector<ProfileCurve>& curves, int holes) {
  const auto beside = static_cast<int>(std::ranges::count_if(curves, &ProfileCurve::closed));
  const int middle = static_cast<int>(curves.size()) - beside;
  return {middle + beside * (holes + 1), middle * holes + beside * (holes + 1)};
}

ProfileCurve withRows(const ProfileCurve& curve, double step) {
  std::vector<SectionPoint> line = curve.points;
  const std::size_t n = line.size();
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < n; ++i) {
    const bool end = !curve.closed && (i == 0 || i + 1 == n);
    if (end || isCorner(line[(i + n - 1) % n], line[i], line[(i + 1) % n])) corners.push_back(i);
  }
  if (corners.empty()) corners.push_back(0);
  if (curve.closed) {
    const std::size_t first = corners[0];
    std::ranges::rotate(line, line.begin() + static_cast<std::ptrdiff_t>(first));
    for (std::size_t& corner : corners) corner -= first;
    line.push_back(line.front());
    corners.push_back(n);
  }
  ProfileCurve out{{}, curve.closed};
  const std::vector<double> s = geometry::arcLengths(std::span<const SectionPoint>(line));
  constexpr double kLeastSteps = 6;  // of a whole curve
  step = std::min(step, s.back() / kLeastSteps);
  for (std::size_t c = 0; c + 1 < corners.size(); ++c) {
    const double from = s[corners[c]], to = s[corners[c + 1]];
    const int steps = std::max(1, static_cast<int>(std::lround((to - from) / step)));
    for (int k = 0; k < steps; ++k) {
      out.points.push_back(geometry::pointAt(std::span<const SectionPoint>(line), std::span<const double>(s),
                                             from + (to - from) * k / steps));
    }
  }
  if (!curve.closed) out.points.push_back(line.back());
  for (std::size_t i = 0; i < out.points.size(); ++i) {
    const bool onAxis = !curve.closed && (i == 0 || i + 1 == out.points.size());
    if (!onAxis) out.points[i].x = std::max(out.points[i].x, kNearAxis);
  }
  return out;
}

}  // namespace spineloft::inflate
