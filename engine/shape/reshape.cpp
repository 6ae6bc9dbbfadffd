#include "engine/shape/reshape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "engine/geometry/bounds.h"
#include "engine/geometry/polygon.h"
#include "engine/geometry/polyline.h"

namespace spineloft::shape {
namespace {

constexpr double kClosed = 0.05, kNearlyClosed = 0.3;  // the gap's share of a line's length
constexpr double kAtOutline = 0.06, kSnap = 0.03;      // shares of the outline's size
constexpr double kFade = 0.1;  // of a line's length, over which an end is brought to the outline
constexpr double kTolerance = 0.0015, kLeastTolerance = 0.5;
constexpr double kStraight = 5 * std::numbers::pi / 180;
constexpr double kRound = 1.1;    // the longer over the shorter way of a thing that has no direction
constexpr double kSkewed = 0.03;  // of the length, that the middle of the area is off the middle of the axis

using Line = std::vector<PicturePoint>;

using Box = geometry::Bounds<PicturePoint>;
Box boxOf(const Line& line) { return geometry::boundsOf(std::span<const PicturePoint>(line)); }
double sizeOf(const Line& line) {
  const auto [low, high] = boxOf(line);
  return std::max(high.x - low.x, high.y - low.y);
}

double lengthOf(const Line& line) { return geometry::arcLengths(std::span<const PicturePoint>(line)).back(); }

/// The point of a closed outline nearest to `p`: after which of its points, and where.
struct Foot {
  std::size_t edge = 0;
  PicturePoint at;
  double away = std::numeric_limits<double>::infinity();
};
Foot footOf(const Line& outline, PicturePoint p) {
  Foot best;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const PicturePoint a = outline[i], along = outline[(i + 1) % outline.size()] - a;
    const double length2 = dot(along, along);
    const PicturePoint at = a + along * (length2 > 0 ? std::clamp(dot(p - a, along) / length2, 0.0, 1.0) : 0);
    const double away = distance(p, at);
    if (away < best.away) best = {i, at, away};
  }
  return best;
}

/// From one foot to another along the closed outline, the way its points go.
Line stretch(const Line& outline, const Foot& from, const Foot& to) {
  Line out{from.at};
  const std::size_t n = outline.size();
  const bool sameEdge = from.edge == to.edge;
  const bool ahead = sameEdge && distance(outline[from.edge], from.at) <= distance(outline[to.edge], to.at);
  if (!ahead) {
    std::size_t i = from.edge;
    do {
      i = (i + 1) % n;
      out.push_back(outline[i]);
    } while (i != to.edge);
  }
  out.push_back(to.at);
  return out;
}

/// How far a line is off another one that begins and ends where it does, on average.
double meanDistance(const Line& line, const Line& other) {
  constexpr std::size_t kSamples = 48;
  const Line a = geometry::resample(std::span<const PicturePoint>(line), kSamples);
  const Line b = geometry::resample(std::span<const PicturePoint>(other), kSamples);
  double sum = 0;
  for (std::size_t i = 0; i < kSamples; ++i) sum += distance(a[i], b[i]);
  return sum / kSamples;
}

/// The line with its ends on the outline where they are near it.
Line snapped(const Line& line, const Foot& first, const Foot& last, double size) {
  const std::vector<double> s = geometry::arcLengths(std::span<const PicturePoint>(line));
  const auto fade = [&](double way) {
    const double t = std::clamp(1 - way / (kFade * s.back()), 0.0, 1.0);
    return t * t * (3 - 2 * t);
  };
  Line out = line;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (first.away <= kSnap * size) out[i] = out[i] + (first.at - line.front()) * fade(s[i]);
    if (last.away <= kSnap * size) out[i] = out[i] + (last.at - line.back()) * fade(s.back() - s[i]);
  }
  return out;
}

/// Without what runs past the place where the line meets its own beginning.
Line closedLine(const Line& line) {
  const auto crossing = geometry::findCrossing(line);
  if (!crossing || crossing->second < crossing->first + 3) return line;
  Line loop{crossing->at};
  loop.insert(loop.end(), line.begin() + static_cast<std::ptrdiff_t>(crossing->first) + 1,
              line.begin() + static_cast<std::ptrdiff_t>(crossing->second) + 1);
  const auto area = [](const Line& points) {
    return std::abs(geometry::signedArea(std::span<const PicturePoint>(points)));
  };
  return area(loop) > area(line) / 2 ? loop : line;
}

/// Few points of a closed line.
Line thinned(Line line, double size) {
  geometry::dropRepeats(line, 0.0);
  while (line.size() > 1 && line.front() == line.back()) line.pop_back();
  if (line.size() < 4) return line;
  const double tolerance = std::max(kLeastTolerance, kTolerance * size);
  line.push_back(line.front());
  const auto farthest = std::ranges::max_element(line, {}, [&](PicturePoint p) { return distance(p, line.front()); });
  const auto half = farthest - line.begin();
  const Line one(line.begin(), line.begin() + half + 1), two(line.begin() + half, line.end());
  Line out = geometry::simplifiedLine(std::span<const PicturePoint>(one), tolerance);
  const Line rest = geometry::simplifiedLine(std::span<const PicturePoint>(two), tolerance);
  out.insert(out.end(), rest.begin() + 1, rest.end() - 1);
  return out;
}

struct Frame {
  PicturePoint from, along, aside;
  double length = 0, width = 0;
};
Frame frameOf(const ShapeParams& params) {
  const auto& [from, to] = params.axis;
  const PicturePoint along = normalized(to - from);
  return {from, along, {-along.y, along.x}, distance(from, to), params.width};
}

/// A coordinate that the front shows, where the axis goes from a[0] to a[1], to where it goes from b[0] to b[1].
double carriedAlong(double c, std::array<double, 2> a, std::array<double, 2> b, double wider, double length) {
  if (std::abs(a[1] - a[0]) >= length / 2) return b[0] + (c - a[0]) * (b[1] - b[0]) / (a[1] - a[0]);
  return (b[0] + b[1]) / 2 + (c - (a[0] + a[1]) / 2) * wider;
}

/// Area, its middle, and its second moments about that.
struct Moments {
  double area = 0, xx = 0, xy = 0, yy = 0;
  PicturePoint middle;
};
Moments momentsOf(const Line& outline) {
  Moments m;
  if (outline.empty()) return m;
  const PicturePoint origin = outline.front();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const PicturePoint a = outline[i] - origin, b = outline[(i + 1) % outline.size()] - origin;
    const double twice = cross(a, b);
    m.area += twice / 2;
    m.middle = m.middle + (a + b) * (twice / 6);
    m.xx += twice * (a.x * a.x + a.x * b.x + b.x * b.x) / 12;
    m.yy += twice * (a.y * a.y + a.y * b.y + b.y * b.y) / 12;
    m.xy += twice * (2 * a.x * a.y + a.x * b.y + b.x * a.y + 2 * b.x * b.y) / 24;
  }
  if (m.area == 0) return m;
  m.middle = m.middle / m.area;
  m.xx = m.xx / m.area - m.middle.x * m.middle.x;
  m.yy = m.yy / m.area - m.middle.y * m.middle.y;
  m.xy = m.xy / m.area - m.middle.x * m.middle.y;
  m.middle = m.middle + origin;
  return m;
}

/// The long way of an area.
PicturePoint longWay(const Moments& m) {
  const double half = std::hypot((m.xx - m.yy) / 2, m.xy), mean = (m.xx + m.yy) / 2;
  if (std::sqrt(mean + half) < kRound * std::sqrt(std::max(0.0, mean - half))) return {0, -1};
  const double angle = std::atan2(2 * m.xy, m.xx - m.yy) / 2;
  const PicturePoint way{std::cos(angle), std::sin(angle)};
  if (std::abs(way.x) < std::sin(kStraight)) return {0, -1};
  if (std::abs(way.y) < std::sin(kStraight)) return {1, 0};
  return way.y > 0 ? way * -1.0 : way;
}

}  // namespace

bool isWhole(const Line& outline, const Line& line) {
  if (line.size() < 3 || outline.size() < 3) return false;
  const double gap = distance(line.front(), line.back()), length = lengthOf(line);
  if (gap <= kClosed * length) return true;
  if (gap > kNearlyClosed * length) return false;
  const double off = std::max(footOf(outline, line.front()).away, footOf(outline, line.back()).away);
  return off > kAtOutline * sizeOf(outline);
}

Line redrawn(const Line& outline, const Line& line) {
  if (outline.size() < 3 || line.size() < 2 || !(lengthOf(line) > 0)) return outline;
  if (isWhole(outline, line)) {
    const Line closed = closedLine(line);
    return thinned(closed, sizeOf(closed));
  }
  const double size = sizeOf(outline);
  const Foot first = footOf(outline, line.front()), last = footOf(outline, line.back());
  const Line own = snapped(line, first, last, size);
  const Line ahead = stretch(outline, first, last);
  Line behind = stretch(outline, last, first);
  Line out = own;
  const Line back(behind.rbegin(), behind.rend());
  if (meanDistance(own, ahead) <= meanDistance(own, back)) {
    out.insert(out.end(), behind.begin(), behind.end());
  } else {
    out.insert(out.end(), ahead.rbegin(), ahead.rend());
  }
  return thinned(std::move(out), size);
}

Axis alongOutline(const Axis& axis, const Line& outline) {
  const PicturePoint along = normalized(axis.to - axis.from);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const PicturePoint p : outline) {
    low = std::min(low, dot(p - axis.from, along));
    high = std::max(high, dot(p - axis.from, along));
  }
  return high - low >= kLeastAxis ? Axis{axis.from + along * low, axis.from + along * high} : axis;
}

PicturePoint carried(PicturePoint p, const ShapeParams& from, const ShapeParams& to) {
  const Frame a = frameOf(from), b = frameOf(to);
  const double along = dot(p - a.from, a.along) / a.length, across = dot(p - a.from, a.aside) / a.width;
  return b.from + b.along * (along * b.length) + b.aside * (across * b.width);
}

PicturePoint carried(PicturePoint p, const geometry::View& view, const ShapeParams& from, const ShapeParams& to) {
  ModelPoint at = geometry::inModel(view, p);
  const double wider = to.width / from.width, length = distance(from.axis.from, from.axis.to);
  switch (view.from) {
    case geometry::ViewFrom::Back: {
      const PicturePoint moved = carried(PicturePoint{at.x, -at.y}, from, to);
      at = {moved.x, -moved.y, 0};
      break;
    }
    case geometry::ViewFrom::Top:
      at.x = carriedAlong(at.x, {from.axis.from.x, from.axis.to.x}, {to.axis.from.x, to.axis.to.x}, wider, length);
      break;
    case geometry::ViewFrom::Right:
    case geometry::ViewFrom::Left:
    case geometry::ViewFrom::kCount:
      at.y = carriedAlong(at.y, {-from.axis.from.y, -from.axis.to.y}, {-to.axis.from.y, -to.axis.to.y}, wider, length);
      break;
  }
  return geometry::inView(view, at);
}

Result<ShapeParams> fittedTo(const ShapeParams& params, const Line& outline) {
  const Moments moments = momentsOf(outline);
  if (!(std::abs(moments.area) >= geometry::kLeastRegionArea)) return Error::RegionEmpty;
  PicturePoint along = longWay(moments);
  PicturePoint aside{-along.y, along.x};
  double low = 0, high = 0, left = 0, right = 0;
  for (const PicturePoint p : outline) {
    const PicturePoint off = p - moments.middle;
    low = std::min(low, dot(off, along));
    high = std::max(high, dot(off, along));
    left = std::min(left, dot(off, aside));
    right = std::max(right, dot(off, aside));
  }
  const PicturePoint foot = moments.middle + aside * ((left + right) / 2);
  ShapeParams fitted = params;
  fitted.axis = {foot + along * low, foot + along * high};
  if (-low > high + 2 * kSkewed * (high - low)) std::swap(fitted.axis.from, fitted.axis.to);
  fitted.width = right - left;
  return isValid(fitted) ? Result<ShapeParams>(fitted) : Result<ShapeParams>(Error::RegionEmpty);
}

std::optional<geometry::View> alignedView(geometry::ViewFrom from, const Line& seen, const Line& front) {
  if (seen.size() < 3 || front.size() < 3) return std::nullopt;
  const Box there = boxOf(seen), here = boxOf(front);
  const bool top = from == geometry::ViewFrom::Top;
  const double own = top ? there.high.x - there.low.x : there.high.y - there.low.y;
  const double other = top ? here.high.x - here.low.x : here.high.y - here.low.y;
  if (!(own > 1) || !(other > 1)) return std::nullopt;
  const PicturePoint middle = momentsOf(seen).middle;
  geometry::View view{from, top ? middle.y : middle.x, other / own, 0};
  view.shift = top ? here.low.x - view.scale * there.low.x : view.scale * there.low.y - here.low.y;
  if (from == geometry::ViewFrom::Back) {
    view.shift = here.high.x + view.scale * there.low.x;
    view.middle = there.low.y - here.low.y / view.scale;
  }
  return geometry::isValid(view) ? std::optional(view) : std::nullopt;
}

}  // namespace spineloft::shape
