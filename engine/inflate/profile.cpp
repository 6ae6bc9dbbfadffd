#include "engine/inflate/profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>

#include "engine/geometry/axis_clip.h"
#include "engine/geometry/polygon.h"
#include "engine/geometry/polyline.h"
#include "engine/inflate/crossing.h"
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

/// Mirror images of points along a curve run backwards along another one: each is looked for from the last one on.
bool isMirrored(const Curves& curves) {
  std::vector<std::array<SectionPoint, 2>> edges;
  for (const Curve& curve : curves) {
    for (std::size_t i = 0; i < curve.size(); ++i) edges.push_back({curve[i], curve[(i + 1) % curve.size()]});
  }
  std::size_t last = 0;
  const auto holds = [&](SectionPoint p) {
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const std::size_t edge = (last + edges.size() - k) % edges.size();
      if (geometry::distanceToSegment(p, edges[edge][0], edges[edge][1]) > kLopsided) continue;
      last = edge;
      return true;
    }
    return false;
  };
  return std::ranges::all_of(curves, [&](const Curve& curve) {
    return std::ranges::all_of(curve, [&](SectionPoint p) { return holds({-p.x, p.y}); });
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

/// What a curve must have in common with one of another slice: whether it is beside the axis, and whether what it
/// bounds is solid.
std::pair<bool, bool> kindOf(const ProfileCurve& curve) {
  const auto& points = curve.points;
  const bool solid = curve.closed ? geometry::signedArea(std::span<const SectionPoint>(points)) > 0
                                  : points.front().y < points.back().y;
  return {curve.closed, !solid};
}
/// Orders the curves of a slice: by kind, those on the axis from below, others from the axis outwards.
std::tuple<bool, bool, double> rankOf(const ProfileCurve& curve) {
  const auto [closed, hole] = kindOf(curve);
  double middle = 0;
  for (const SectionPoint p : curve.points) middle += p.x / static_cast<double>(curve.points.size());
  return {closed, hole, closed ? middle : curve.points.front().y};
}
/// A closed curve begins at its lowest place nearest to the outline.
void beginOutside(ProfileCurve& curve) {
  if (!curve.closed) return;
  const auto first = std::ranges::max_element(curve.points, {}, [](SectionPoint p) { return std::pair(p.x, -p.y); });
  std::ranges::rotate(curve.points, first);
}

/// A curve as a line from its beginning to its end, and where its corners are along it: both ends are.
struct Ruled {
  Curve line;
  std::vector<double> s, corners;
  /// After k of so many steps from a corner to the next one.
  SectionPoint at(std::size_t corner, int k, int steps) const {
    const double from = corners[corner], to = corners[corner + 1];
    return geometry::pointAt(std::span<const SectionPoint>(line), std::span<const double>(s),
                             from + (to - from) * k / steps);
  }
};
/// A closed curve begins at its first corner, or where it `begins`.
Ruled ruled(const ProfileCurve& curve, bool begins) {
  Ruled out{curve.points, {}, {}};
  Curve& line = out.line;
  const std::size_t n = line.size();
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < n; ++i) {
    const bool end = curve.closed ? begins && i == 0 : i == 0 || i + 1 == n;
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
  out.s = geometry::arcLengths(std::span<const SectionPoint>(line));
  for (const std::size_t corner : corners) out.corners.push_back(out.s[corner]);
  return out;
}

/// Gives all slices as many corners: those of the same order are one where their numbers agree; else each slice gets a
/// place at the same share of its length for the corners of others.
void alignCorners(std::vector<Ruled>& slices) {
  const auto count = [](const Ruled& slice) { return slice.corners.size(); };
  if (std::ranges::all_of(slices, [&](const Ruled& slice) { return count(slice) == count(slices.front()); })) return;
  constexpr double kSameCorner = 0.02;  // of the length
  struct Corner {
    double share;
    std::size_t slice;
    double at;
  };
  std::vector<Corner> all;
  for (std::size_t k = 0; k < slices.size(); ++k) {
    for (const double at : slices[k].corners) all.push_back({at / slices[k].s.back(), k, at});
  }
  std::ranges::stable_sort(all, {}, &Corner::share);
  std::vector<std::vector<double>> corners(slices.size());
  for (std::size_t from = 0, to = 0; from < all.size(); from = to) {
    std::vector<char> has(slices.size(), 0);
    double sum = 0;
    while (to < all.size() && all[to].share <= all[from].share + kSameCorner && !has[all[to].slice]) {
      has[all[to].slice] = 1;
      sum += all[to++].share;
    }
    const double share = sum / static_cast<double>(to - from);
    for (std::size_t k = 0; k < slices.size(); ++k) {
      if (!has[k]) corners[k].push_back(share * slices[k].s.back());
    }
    for (std::size_t i = from; i < to; ++i) corners[all[i].slice].push_back(all[i].at);
  }
  for (std::size_t k = 0; k < slices.size(); ++k) slices[k].corners = std::move(corners[k]);
}

/// Whether no two curves of a profile half, a quarter or three quarters on the way from one slice to another cross.
bool blendsAreSimple(const MatchedCurves& matched) {
  constexpr double kStep = 0.06;
  const std::size_t slices = matched.front().size();
  for (std::size_t k = 0; k < slices; ++k) {
    for (std::size_t other = k + 1; other < slices; ++other) {
      for (const double share : {0.25, 0.5, 0.75}) {
        std::vector<std::array<SectionPoint, 2>> edges;
        for (const std::vector<ProfileCurve>& curve : matched) {
          Curve line;
          for (const ProfileRow& row : rowsOf(std::array{curve[k], curve[other]}, kStep))
            line.push_back(lerp(row[0], row[1], share));
          for (std::size_t i = curve[k].closed ? 0 : 1; i < line.size(); ++i)
            edges.push_back({line[(i + line.size() - 1) % line.size()], line[i]});
        }
        for (std::size_t i = 0; i < edges.size(); ++i) {
          for (std::size_t j = 0; j < i; ++j) {
            if (crossing(edges[i][0], edges[i][1], edges[j][0], edges[j][1])) return false;
          }
        }
      }
    }
  }
  return true;
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

Result<MatchedCurves> matchedCurves(std::span<const ProfileSlice> slices, InflateSides sides) {
  const auto everywhere = [](const ProfileSlice& slice) { return !slice.at; };
  if (std::ranges::count_if(slices, everywhere) > 1) return refused("more than one slice of the puff has no place");
  MatchedCurves matched;
  for (std::size_t k = 0; k < slices.size(); ++k) {
    Result<std::vector<ProfileCurve>> read = profileCurves(slices[k].shape, sides);
    if (!read) return read.failure();
    std::vector<ProfileCurve> curves = std::move(read).value();
    if (slices.size() > 1) std::ranges::stable_sort(curves, {}, rankOf);
    if (k == 0) matched.resize(curves.size());
    bool same = curves.size() == matched.size();
    for (std::size_t c = 0; c < curves.size() && same; ++c) {
      same = k == 0 || kindOf(curves[c]) == kindOf(matched[c].front());
      matched[c].push_back(std::move(curves[c]));
    }
    if (!same) return refused("the slices of a puff need as many bodies, rings and holes each");
  }
  if (slices.size() < 2) return matched;
  for (std::vector<ProfileCurve>& curve : matched) std::ranges::for_each(curve, beginOutside);
  if (!blendsAreSimple(matched)) return refused("on the way from one slice to another they would cross themselves");
  return matched;
}

bool isPlain(const MatchedCurves& curves) {
  if (curves.size() != 1 || curves.front().size() != 1 || curves.front().front().closed) return false;
  const Curve& line = curves.front().front().points;
  bool back = false;
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (i + 1 < line.size() && isCorner(line[i - 1], line[i], line[i + 1])) return false;
    if (back && line[i].x > line[i - 1].x + kSame) return false;
    back = back || line[i].x < line[i - 1].x - kSame;
  }
  return true;
}

Topology topologyOf(const std::vector<ProfileCurve>& curves, int holes) {
  const auto beside = static_cast<int>(std::ranges::count_if(curves, &ProfileCurve::closed));
  const int middle = static_cast<int>(curves.size()) - beside;
  return {middle + beside * (holes + 1), middle * holes + beside * (holes + 1)};
}

std::vector<ProfileRow> rowsOf(std::span<const ProfileCurve> curve, double step) {
  std::vector<Ruled> slices;
  for (const ProfileCurve& one : curve) slices.push_back(ruled(one, curve.size() > 1));
  alignCorners(slices);
  const bool closed = curve.front().closed;
  std::vector<ProfileRow> rows;
  const auto put = [&](std::size_t corner, int k, int steps) {
    ProfileRow& row = rows.emplace_back();
    for (const Ruled& slice : slices) row.push_back(slice.at(corner, k, steps));
  };
  constexpr double kLeastSteps = 6;  // of a whole curve
  double longest = 0;
  for (const Ruled& slice : slices) longest = std::max(longest, slice.s.back());
  step = std::min(step, longest / kLeastSteps);
  const std::size_t stretches = slices.front().corners.size() - 1;
  for (std::size_t c = 0; c < stretches; ++c) {
    double length = 0;
    for (const Ruled& slice : slices) length = std::max(length, slice.corners[c + 1] - slice.corners[c]);
    const int steps = std::max(1, static_cast<int>(std::lround(length / step)));
    for (int k = 0; k < steps; ++k) put(c, k, steps);
  }
  if (!closed) put(stretches - 1, 1, 1);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool onAxis = !closed && (i == 0 || i + 1 == rows.size());
    for (SectionPoint& p : rows[i]) p.x = onAxis ? 0 : std::max(p.x, kNearAxis);
  }
  return rows;
}

}  // namespace spineloft::inflate
