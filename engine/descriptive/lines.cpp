#include "engine/descriptive/lines.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/geometry/polyline.h"

namespace spineloft::descriptive {
namespace {

/// Where on a line the nearest point to p is.
struct Nearest {
  double distance = std::numeric_limits<double>::infinity(), s = 0;
};
Nearest nearestOn(const MeasuredLine& line, PicturePoint p) {
  Nearest best;
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    const PicturePoint a = line.points[i], along = line.points[i + 1] - a;
    const double squared = dot(along, along);
    const double t = squared > 0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
    const double away = distance(p, a + along * t);
    if (away < best.distance) best = {away, line.s[i] + t * std::sqrt(squared)};
  }
  return best;
}

void measure(MeasuredLine& line) { geometry::arcLengths(std::span<const PicturePoint>(line.points), line.s); }

Result<MeasuredLine> measured(const Line& line) {
  MeasuredLine out{line.points, {}, line.hidden, line.closed};
  if (line.points.size() > kMostLinePoints) return Error::ValueOutOfRange;
  for (const PicturePoint p : line.points) {
    if (!isFinite(p)) return Error::StrokeNotFinite;
  }
  double last = 0;
  for (const Stretch& stretch : line.hidden) {
    if (!(stretch.from >= last && stretch.to > stretch.from && stretch.to <= 1)) return Error::ValueOutOfRange;
    last = stretch.to;
  }
  if (out.points.empty()) return Error::StrokeTooShort;
  geometry::dropRepeats(out.points, 1e-9);
  if (out.closed && out.points.size() > 1 && distance(out.points.front(), out.points.back()) < 1e-9) {
    out.points.pop_back();
  }
  if (out.points.size() < (out.closed ? 3u : 2u)) return Error::StrokeTooShort;
  if (out.closed) out.points.push_back(out.points.front());
  measure(out);
  return out;
}

/// Shares after the line became longer or shorter at its ends: what was at arc length `s` is at `s − before`.
void moveStretches(MeasuredLine& line, double lengthBefore, double cutBefore) {
  for (Stretch& stretch : line.hidden) {
    // A stretch that reached an end still does.
    const auto moved = [&](double share) {
      return share <= 0 || share >= 1 ? share
                                      : std::clamp((share * lengthBefore - cutBefore) / line.length(), 0.0, 1.0);
    };
    stretch = {moved(stretch.from), moved(stretch.to)};
  }
  std::erase_if(line.hidden, [](const Stretch& one) { return !(one.to > one.from); });
}

/// One end of an open line.
struct End {
  std::uint32_t line;
  bool last;
};
PicturePoint pointOf(const std::vector<MeasuredLine>& lines, End end) {
  const auto& points = lines[end.line].points;
  return end.last ? points.back() : points.front();
}
void moveEnd(std::vector<MeasuredLine>& lines, End end, PicturePoint to) {
  MeasuredLine& line = lines[end.line];
  const double before = line.length();
  const double first = distance(line.points[0], line.points[1]);
  (end.last ? line.points.back() : line.points.front()) = to;
  measure(line);
  moveStretches(line, before, end.last ? 0 : first - distance(line.points[0], line.points[1]));
}

/// Whether both ends of a line lie on others, apart from each other: what is as narrow as a hand misses.
bool standsOnOthers(const std::vector<MeasuredLine>& lines, std::uint32_t number, double size) {
  const MeasuredLine& line = lines[number];
  const auto isOnAnother = [&](PicturePoint end) {
    for (std::uint32_t k = 0; k < lines.size(); ++k) {
      if (k != number && nearestOn(lines[k], end).distance <= kWelding * size) return true;
    }
    return false;
  };
  return !line.closed && distance(line.points.front(), line.points.back()) >= kContact * size &&
         isOnAnother(line.points.front()) && isOnAnother(line.points.back());
}

void closeLines(std::vector<MeasuredLine>& lines, double size) {
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    MeasuredLine& line = lines[i];
    if (line.closed) continue;
    const double gap = distance(line.points.front(), line.points.back());
    if (gap > kClosing * size || line.points.size() < 4 || line.length() < 4 * std::max(gap, kClosing * size)) continue;
    if (standsOnOthers(lines, i, size)) continue;
    const double before = line.length();
    // Ends that nearly meet are one point, others are joined straight.
    if (gap < kContact * size) line.points.pop_back();
    line.points.push_back(line.points.front());
    line.closed = true;
    measure(line);
    moveStretches(line, before, 0);
  }
}

/// Ends of several lines near to each other; what is left over.
std::vector<End> weldEnds(std::vector<MeasuredLine>& lines, double size) {
  std::vector<End> ends;
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    if (!lines[i].closed) ends.insert(ends.end(), {{i, false}, {i, true}});
  }
  std::vector<End> alone;
  std::vector<bool> taken(ends.size(), false);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (taken[i]) continue;
    std::vector<std::size_t> cluster{i};
    for (std::size_t k = i + 1; k < ends.size(); ++k) {
      const bool near = !taken[k] && distance(pointOf(lines, ends[i]), pointOf(lines, ends[k])) <= kWelding * size;
      const bool isOneLine = ends[k].line == ends[i].line;
      if (near && !(isOneLine && standsOnOthers(lines, ends[i].line, size))) cluster.push_back(k);
    }
    if (cluster.size() == 1) {
      alone.push_back(ends[i]);
      continue;
    }
    PicturePoint mean{};
    for (const std::size_t k : cluster) mean += pointOf(lines, ends[k]) / static_cast<double>(cluster.size());
    for (const std::size_t k : cluster) {
      taken[k] = true;
      moveEnd(lines, ends[k], mean);
    }
  }
  return alone;
}

template <class AnyLine>
double longerSide(std::span<const AnyLine> lines) {
  PicturePoint low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  for (const AnyLine& line : lines) {
    for (const PicturePoint p : line.points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  return lines.empty() ? 0 : std::max({high.x - low.x, high.y - low.y, 0.0});
}

/// Where the segments a–b and c–d cross: the shares of both. None for parallel ones.
bool crossing(PicturePoint a, PicturePoint b, PicturePoint c, PicturePoint d, double& t, double& u) {
  const PicturePoint r = b - a, q = d - c;
  const double whole = cross(r, q);
  if (whole == 0) return false;
  t = cross(c - a, q) / whole;
  u = cross(c - a, r) / whole;
  return t >= 0 && t <= 1 && u >= 0 && u <= 1;
}

/// Puts an end on a line that is near, and cuts what goes beyond it.
void endOnLine(std::vector<MeasuredLine>& lines, End end, double size) {
  const PicturePoint tip = pointOf(lines, end);
  Nearest best;
  std::uint32_t other = 0;
  for (std::uint32_t k = 0; k < lines.size(); ++k) {
    if (k == end.line) continue;
    const Nearest here = nearestOn(lines[k], tip);
    if (here.distance < best.distance) {
      best = here;
      other = k;
    }
  }
  if (best.distance > kWelding * size || lines[end.line].length() < 4 * kWelding * size) return;
  MeasuredLine& line = lines[end.line];
  if (end.last) std::ranges::reverse(line.points);
  // The overshoot: segments up to the first crossing from the tip, as far as kWelding.
  double way = 0;
  for (std::size_t i = 0; i + 1 < line.points.size() && way < kWelding * size; ++i) {
    for (std::size_t k = 0; k + 1 < lines[other].points.size(); ++k) {
      double t = 0, u = 0;
      const auto& points = lines[other].points;
      if (!crossing(line.points[i], line.points[i + 1], points[k], points[k + 1], t, u)) continue;
      if (i == 0 && t < 1e-9) continue;
      const double before = line.length(), cut = way + t * distance(line.points[i], line.points[i + 1]);
      if (cut > kWelding * size) continue;
      line.points[i] = lerp(line.points[i], line.points[i + 1], t);
      line.points.erase(line.points.begin(), line.points.begin() + static_cast<std::ptrdiff_t>(i));
      if (line.points.size() > 2 && distance(line.points[0], line.points[1]) < 1e-9)
        line.points.erase(line.points.begin());
      if (end.last) std::ranges::reverse(line.points);
      measure(line);
      moveStretches(line, before, end.last ? 0 : cut);
      return;
    }
    way += distance(line.points[i], line.points[i + 1]);
  }
  if (end.last) std::ranges::reverse(line.points);
  moveEnd(lines, end, lines[other].at(best.s / lines[other].length()));
}

}  // namespace

PicturePoint MeasuredLine::at(double share) const {
  return geometry::pointAt(std::span<const PicturePoint>(points), std::span<const double>(s), share * length());
}

bool MeasuredLine::isHidden(double share) const {
  return std::ranges::any_of(hidden, [&](const Stretch& one) { return one.from <= share && share <= one.to; });
}

double sizeOf(std::span<const Line> lines) { return longerSide(lines); }
double sizeOf(std::span<const MeasuredLine> lines) { return longerSide(lines); }

Result<std::vector<MeasuredLine>> meetingLines(std::span<const Line> lines) {
  if (lines.size() > kMostLines) return Error::ValueOutOfRange;
  std::vector<MeasuredLine> out;
  for (const Line& line : lines) {
    Result<MeasuredLine> one = measured(line);
    if (!one) return one.failure();
    out.push_back(std::move(one).value());
  }
  const double size = sizeOf(lines);
  closeLines(out, size);
  for (const End end : weldEnds(out, size)) endOnLine(out, end, size);
  return out;
}

}  // namespace spineloft::descriptive
