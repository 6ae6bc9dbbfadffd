#include "engine/descriptive/completion.h"

#include <algorithm>
#include <cmath>

#include "engine/geometry/line_distance.h"
#include "engine/geometry/polygon.h"

namespace spineloft::descriptive {
namespace {

constexpr int kLooks = 16;      // places at which the end of a line is looked at
constexpr int kWayPoints = 24;  // of a hidden way
/// A handle is so many times as long as that of the arc with the same turn and equal angles.
constexpr double kShortest = 0.6, kLongest = 1.6;
/// Curvature times the distance of the ends that is measured and not chance, and rounds in which handles settle.
constexpr double kLeastBend = 0.5;
constexpr int kRounds = 8;
/// So much of a way may be outside of all covers: ends lie on their edges.
constexpr double kUncovered = 0.1;

double angleBetween(PicturePoint one, PicturePoint other) { return std::atan2(cross(one, other), dot(one, other)); }

/// How two ends lie to each other.
struct Between {
  PicturePoint chord;
  double near = 0, far = 0;  ///< from the first end to the chord, from the chord to the other end; radians
  double turn() const { return std::abs(near) + std::abs(far); }
};
Between betweenOf(const LineEnd& from, const LineEnd& to) {
  const PicturePoint chord = to.at - from.at;
  return {chord, angleBetween(from.along, chord), angleBetween(chord, -to.along)};
}

/// The handle that goes with all arcs of this turn and these angles, and the one of a circle; pixels. `far`: the angle
/// at the other end.
struct Handle {
  double own = 0, even = 0;
  double within(double length) const { return std::clamp(length, kShortest * even, kLongest * even); }
};
Handle handleOf(const Between& between, double far) {
  const double turn = std::min(between.turn(), kMostHiddenTurn), c = norm(between.chord);
  const double half = std::sin(turn / 2), quarter = std::cos(turn / 4);
  Handle handle;
  handle.even = c / (3 * quarter * quarter);
  // What turns to one side and then to the other is no arc.
  if (between.near * between.far <= 0) return {handle.even, handle.even};
  handle.own = handle.within(2.0 / 3 * c * std::tan(turn / 4) * std::sin(std::abs(far)) / (half * half));
  return handle;
}

using Cubic = std::array<PicturePoint, 4>;
Cubic cubicOf(const LineEnd& from, const LineEnd& to, double handle, double otherHandle) {
  return {from.at, from.at + from.along * handle, to.at + to.along * otherHandle, to.at};
}

/// It bends at both ends as the lines do, where they bend to its side by enough to be measured.
Cubic bentAlike(const LineEnd& from, const LineEnd& to, const Between& between) {
  const Handle near = handleOf(between, between.far), far = handleOf(between, between.near);
  double one = near.own, other = far.own;
  const bool isArc = between.near * between.far > 0;
  if (!isArc) return cubicOf(from, to, one, other);
  const double c = norm(between.chord), side = between.near < 0 ? -1 : 1;
  // A cubic bends less at its ends than the arc of a circle that it stands for.
  const double even = near.even / c, half = std::min(between.turn(), kMostHiddenTurn) / 2;
  const double share = (1 - 2 * even * std::cos(half)) / (3 * even * even);
  const double bend = side * from.bend * share, otherBend = -side * to.bend * share;
  for (int round = 0; round < kRounds; ++round) {
    const Cubic now = cubicOf(from, to, one, other);
    // How far the third point is off the tangent.
    const double off = std::abs(cross(from.along, now[2] - now[0])),
                 otherOff = std::abs(cross(to.along, now[1] - now[3]));
    if (bend * c > kLeastBend) one = near.within(std::sqrt(2.0 / 3 * off / bend));
    if (otherBend * c > kLeastBend) other = far.within(std::sqrt(2.0 / 3 * otherOff / otherBend));
  }
  return cubicOf(from, to, one, other);
}

/// The curvature of a cubic at its first point.
double bendOf(PicturePoint p0, PicturePoint p1, PicturePoint p2) {
  const PicturePoint first = p1 - p0;
  const double length = norm(first);
  return length > 0 ? 2.0 / 3 * cross(first, p2 - p1) / (length * length * length) : 0.0;
}

double costOf(const LineEnd& from, const LineEnd& to, const Between& between, double size) {
  const auto [p0, p1, p2, p3] =
      cubicOf(from, to, handleOf(between, between.far).own, handleOf(between, between.near).own);
  const double c = norm(between.chord);
  // Whoever goes the other way turns to the other side.
  const double off = c * (bendOf(p0, p1, p2) - from.bend), otherOff = c * (bendOf(p3, p2, p1) - to.bend);
  return off * off + otherOff * otherOff + kWayWeight * c / size;
}

bool holds(const Cover& cover, PicturePoint p) {
  return geometry::holds(std::span<const PicturePoint>(cover.outline), p);
}
bool isOf(const Cover& cover, std::uint32_t line) { return std::ranges::find(cover.lines, line) != cover.lines.end(); }

bool leadsInto(const LineEnd& end, const Cover& cover, double size) {
  return !isOf(cover, end.line) && holds(cover, end.at + end.along * (kWelding * size)) &&
         geometry::distanceToLine(end.at, std::span<const PicturePoint>(cover.outline), true) <= kContact * size;
}

bool isCovered(std::span<const Cover> covers, const LineEnd& from, const LineEnd& to) {
  const HiddenWay way = hiddenWay(from, to);
  const double most = kUncovered * static_cast<double>(way.points.size());
  double outside = 0;
  for (std::size_t i = 1; i + 1 < way.points.size() && outside <= most; ++i) {
    const bool isHidden = std::ranges::any_of(covers, [&](const Cover& cover) {
      return !isOf(cover, from.line) && !isOf(cover, to.line) && holds(cover, way.points[i]);
    });
    if (!isHidden) ++outside;
  }
  return outside <= most;
}

}  // namespace

LineEnd endOf(std::span<const MeasuredLine> lines, std::uint32_t number, bool last) {
  const MeasuredLine& line = lines[number];
  const PicturePoint end = last ? line.points.back() : line.points.front();
  // p(s) = end + a s + b s², s going into the line; least squares.
  double s2 = 0, s3 = 0, s4 = 0;
  PicturePoint first{}, second{};
  for (int i = 1; i <= kLooks; ++i) {
    const double s = static_cast<double>(i) / kLooks, share = kEndLook * s;
    const PicturePoint off = line.at(last ? 1 - share : share) - end;
    s2 += s * s;
    s3 += s * s * s;
    s4 += s * s * s * s;
    first += off * s;
    second += off * (s * s);
  }
  const double whole = s2 * s4 - s3 * s3;
  const PicturePoint a = (first * s4 - second * s3) / whole, b = (second * s2 - first * s3) / whole;
  const double speed = norm(a);
  return {number, end, normalized(-a), speed > 0 ? -2 * cross(a, b) / (speed * speed * speed) : 0.0};
}

bool goesUnder(std::span<const MeasuredLine> lines, const LineEnd& end, double size) {
  const PicturePoint ahead = end.at + end.along * (kWelding * size);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::span<const PicturePoint> points = lines[k].points;
    if (k == end.line || geometry::distanceToLine(end.at, points) > kContact * size) continue;
    if (!lines[k].closed || geometry::holds(points, ahead)) return true;
  }
  return false;
}

HiddenWay hiddenWay(const LineEnd& from, const LineEnd& to) {
  const Between between = betweenOf(from, to);
  const auto [p0, p1, p2, p3] = bentAlike(from, to, between);
  HiddenWay way;
  way.turn = between.turn();
  for (int i = 0; i <= kWayPoints; ++i) {
    const double t = static_cast<double>(i) / kWayPoints, u = 1 - t;
    way.points.push_back(p0 * (u * u * u) + p1 * (3 * u * u * t) + p2 * (3 * u * t * t) + p3 * (t * t * t));
  }
  return way;
}

std::vector<std::array<std::size_t, 2>> hiddenPairs(std::span<const LineEnd> ends, std::span<const Cover> covers,
                                                    double size) {
  std::vector<std::size_t> going;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (std::ranges::any_of(covers, [&](const Cover& cover) { return leadsInto(ends[i], cover, size); })) {
      going.push_back(i);
    }
  }
  struct Pair {
    double cost;
    std::array<std::size_t, 2> ends;
  };
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < going.size(); ++i) {
    for (std::size_t k = i + 1; k < going.size(); ++k) {
      const LineEnd &from = ends[going[i]], &to = ends[going[k]];
      const Between between = betweenOf(from, to);
      if (between.turn() > kMostHiddenTurn || norm(between.chord) <= kContact * size) continue;
      pairs.push_back({costOf(from, to, between, size), {going[i], going[k]}});
    }
  }
  std::ranges::stable_sort(pairs, {}, &Pair::cost);
  std::vector<int> tries(ends.size(), 0);
  std::vector<std::array<std::size_t, 2>> out;
  for (const auto& [cost, pair] : pairs) {
    int &one = tries[pair[0]], &other = tries[pair[1]];
    if (one >= kMostTries || other >= kMostTries) continue;
    ++one;
    ++other;
    if (!isCovered(covers, ends[pair[0]], ends[pair[1]])) continue;
    one = other = kMostTries;
    out.push_back(pair);
  }
  return out;
}

}  // namespace spineloft::descriptive
