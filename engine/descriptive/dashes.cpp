#include "engine/descriptive/dashes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/descriptive/lines.h"
#include "engine/geometry/stroke_line.h"

namespace spineloft::descriptive {
namespace {

/// A longer way along a dash than this times the way from end to end is no dash.
constexpr double kMostCrooked = 1.15;

/// An end is led as far as this times the longest gap.
constexpr double kReach = 1.5;

using Points = std::vector<PicturePoint>;

PicturePoint chordOf(const Points& points) { return points.back() - points.front(); }

bool isShort(const Line& line, double size) {
  if (line.closed || !line.hidden.empty() || line.points.size() < 2) return false;
  const double chord = norm(chordOf(line.points));
  return chord > 0 && chord <= kLongestDash * size && geometry::lengthOf(line.points) <= kMostCrooked * chord;
}

double turnBetween(PicturePoint one, PicturePoint other) {
  return std::abs(std::atan2(cross(one, other), dot(one, other)));
}

/// Both turned so that the ends that are nearest to each other follow each other.
std::pair<Points, Points> inOrder(const Line& first, const Line& second) {
  std::pair<Points, Points> best;
  double least = INFINITY;
  for (const bool turnFirst : {false, true}) {
    for (const bool turnSecond : {false, true}) {
      Points a = first.points, b = second.points;
      if (turnFirst) std::ranges::reverse(a);
      if (turnSecond) std::ranges::reverse(b);
      if (distance(a.back(), b.front()) >= least) continue;
      least = distance(a.back(), b.front());
      best = {std::move(a), std::move(b)};
    }
  }
  return best;
}

/// All points of dashes in order, and the longest gap between two of them.
struct Joined {
  Points points;
  double gap = 0;
};
Joined joined(std::span<const Line> dashes) {
  Joined out{inOrder(dashes[0], dashes[1]).first, 0};
  for (const Line& dash : dashes.subspan(1)) {
    Points next = dash.points;
    if (distance(out.points.back(), next.back()) < distance(out.points.back(), next.front())) {
      std::ranges::reverse(next);
    }
    out.gap = std::max(out.gap, distance(out.points.back(), next.front()));
    out.points.insert(out.points.end(), next.begin(), next.end());
  }
  return out;
}

}  // namespace

bool isDashAfter(const Line& last, const Line& stroke, double size) {
  if (!isShort(last, size) || !isShort(stroke, size)) return false;
  const double one = norm(chordOf(last.points)), other = norm(chordOf(stroke.points));
  if (std::max(one, other) > kMostRatio * std::min(one, other)) return false;
  const auto [a, b] = inOrder(last, stroke);
  const PicturePoint gap = b.front() - a.back();
  const double share = norm(gap) / ((one + other) / 2);
  if (share < kLeastGap || share > kMostGap) return false;
  return turnBetween(chordOf(a), gap) <= kMostTurn && turnBetween(gap, chordOf(b)) <= kMostTurn;
}

std::optional<Line> dashedLine(std::span<const Line> lines, std::size_t first, std::size_t end, double size) {
  if (end - first < kLeastDashes) return std::nullopt;
  auto [points, gap] = joined(lines.subspan(first, end - first));
  const double reach = std::max(kWelding * size, kReach * gap);
  if (distance(points.front(), points.back()) <= reach) return Line{std::move(points), {{0, 1}}, true};
  // The nearest open end of another line; no end is both.
  std::optional<PicturePoint> from, to;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if ((i >= first && i < end) || lines[i].closed || lines[i].points.size() < 2) continue;
    for (const PicturePoint p : {lines[i].points.front(), lines[i].points.back()}) {
      const double away = distance(p, points.front()), other = distance(p, points.back());
      if (away <= reach && away <= other && (!from || away < distance(*from, points.front()))) from = p;
      if (other <= reach && other < away && (!to || other < distance(*to, points.back()))) to = p;
    }
  }
  if (!from || !to) return std::nullopt;
  points.insert(points.begin(), *from);
  points.push_back(*to);
  return Line{std::move(points), {{0, 1}}, false};
}

std::size_t firstDash(std::span<const Line> lines, double size) {
  std::size_t first = lines.empty() ? 0 : lines.size() - 1;
  while (first > 0 && isDashAfter(lines[first - 1], lines[first], size)) --first;
  return first;
}

std::vector<Line> withoutDashes(std::span<const Line> lines) {
  std::vector<Line> out;
  const double size = sizeOf(lines);
  for (std::size_t i = 0; i < lines.size();) {
    std::size_t end = i + 1;
    while (end < lines.size() && isDashAfter(lines[end - 1], lines[end], size)) ++end;
    if (std::optional<Line> dashed = dashedLine(lines, i, end, size)) {
      out.push_back(std::move(*dashed));
    } else {
      out.insert(out.end(), lines.begin() + static_cast<std::ptrdiff_t>(i),
                 lines.begin() + static_cast<std::ptrdiff_t>(end));
    }
    i = end;
  }
  return out;
}

}  // namespace spineloft::descriptive
