#include "engine/shape/side_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "engine/geometry/polygon.h"
#include "engine/geometry/polyline.h"
#include "engine/geometry/region.h"

namespace spineloft::shape {
namespace {

/// Shares of the length along the axis: what is straight across, what is no step back, and most of one.
constexpr double kLevel = 1e-6, kHair = 1e-3, kMostBack = 0.1;
/// How much the length counts in the shares of a line that steps back.
constexpr double kByLength = 0.05;
/// Windows over which a line is evened out, shares of its length: about as far as sections stand apart; and wider
/// ones where it crosses itself. What does not cross itself without detours of less than kSlip of the length along the
/// axis has slips of the hand at most.
constexpr std::array kTremor = {1.0 / 64, 1.0 / 32, 1.0 / 16};
constexpr double kSlip = 0.015;
/// An outline of a second view may be this share longer or shorter than the first, or stand this much off it.
constexpr double kMostOff = 0.25;
/// Corners turn by more than this (radians), seen on the line simplified by this share of its length along the axis.
constexpr double kCorner = 0.45, kCornerSlack = 0.003;

/// The mean of x by length.
double meanAcross(const Line& line) {
  double sum = 0, length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double step = distance(line[i - 1], line[i]);
    sum += step * (line[i - 1].x + line[i].x) / 2;
    length += step;
  }
  return length > 0 ? sum / length : line.front().x;
}

/// A closed line as two, from where it begins along the axis to where it ends.
std::vector<Line> split(const Line& closed) {
  const auto [first, last] = std::ranges::minmax_element(closed, {}, &SectionPoint::y);
  const std::size_t n = closed.size(), from = static_cast<std::size_t>(first - closed.begin()),
                    to = static_cast<std::size_t>(last - closed.begin());
  Line ahead, behind;
  for (std::size_t i = from; i != to; i = (i + 1) % n) ahead.push_back(closed[i]);
  for (std::size_t i = from; i != to; i = (i + n - 1) % n) behind.push_back(closed[i]);
  ahead.push_back(closed[to]);
  behind.push_back(closed[to]);
  return {std::move(ahead), std::move(behind)};
}

/// The outline that two lines make together.
Line outlineOf(const Line& low, const Line& high) {
  Line outline = low;
  outline.insert(outline.end(), high.rbegin(), high.rend());
  geometry::dropRepeats(outline, 0.0);
  while (outline.size() > 1 && outline.front() == outline.back()) outline.pop_back();
  return outline;
}

/// The line through the means of what lies within half a window on both sides of its places, its ends as they are. A
/// line that is known no finer than the window stays as it is: nothing of it is tremor.
Line evened(const Line& line, double window) {
  constexpr std::size_t kSteps = 4;  // of half a window
  const auto points = static_cast<std::size_t>(2 * kSteps / window);
  if (static_cast<double>(line.size()) * window < 1) return line;
  const Line even = geometry::resample(std::span<const SectionPoint>(line), points + 1);
  std::vector<SectionPoint> sums{SectionPoint{}};
  for (const SectionPoint p : even) sums.push_back(sums.back() + p);
  Line out = even;
  for (std::size_t i = 0; i < even.size(); ++i) {
    const std::size_t reach = std::min({kSteps, i, even.size() - 1 - i});
    out[i] = (sums[i + reach + 1] - sums[i - reach]) / static_cast<double>(2 * reach + 1);
  }
  return out;
}

bool isSimple(const Line& low, const Line& high) { return geometry::isSimple(outlineOf(low, high)); }

}  // namespace

SideLine::SideLine(Line points) : points_(std::move(points)) {
  const double length = points_.back().y - points_.front().y, level = kLevel * length;
  std::size_t first = 0, last = points_.size() - 1;
  while (first + 1 < last && std::abs(points_[first + 1].y - points_.front().y) <= level) ++first;
  while (last > first + 1 && std::abs(points_[last - 1].y - points_.back().y) <= level) --last;
  points_ = Line(points_.begin() + static_cast<std::ptrdiff_t>(first),
                 points_.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  bool ahead = true;
  double farthest = start();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const SectionPoint p = points_[i];
    farthest = std::max(farthest, p.y);
    shares_.push_back(farthest - start());
    back_ = std::max({back_, farthest - p.y, p.y - end()});
    const bool across = i > 0 && p.y - points_[i - 1].y <= level && std::abs(p.x - points_[i - 1].x) > kHair * length;
    ahead = ahead && !across && back_ <= kHair * length;
  }
  const std::vector<double> lengths = geometry::arcLengths(std::span<const SectionPoint>(points_));
  for (std::size_t i = 0; i < points_.size(); ++i) {
    shares_[i] /= farthest - start();
    if (!ahead) shares_[i] = std::lerp(shares_[i], lengths[i] / lengths.back(), kByLength);
  }
}

void SideLine::stretch(double from, double to, double newFrom, double newTo) {
  for (SectionPoint& p : points_) p.y = newFrom + (p.y - from) * (newTo - newFrom) / (to - from);
}

SectionPoint SideLine::at(double share) const {
  const auto above = std::ranges::upper_bound(shares_, share);
  if (above == shares_.begin()) return points_.front();
  if (above == shares_.end()) return points_.back();
  const auto i = static_cast<std::size_t>(above - shares_.begin());
  return lerp(points_[i - 1], points_[i], (share - shares_[i - 1]) / (shares_[i] - shares_[i - 1]));
}

std::vector<double> SideLine::corners() const {
  const double slack = kCornerSlack * (end() - start());
  const std::vector<std::size_t> kept = geometry::keptPoints(std::span<const SectionPoint>(points_), slack);
  std::vector<double> out;
  for (std::size_t i = 1; i + 1 < kept.size(); ++i) {
    const SectionPoint in = points_[kept[i]] - points_[kept[i - 1]], on = points_[kept[i + 1]] - points_[kept[i]];
    if (std::abs(std::atan2(cross(in, on), dot(in, on))) > kCorner) out.push_back(shares_[kept[i]]);
  }
  return out;
}

double SideLines::widest() const {
  const auto least = std::ranges::min_element(low.points(), {}, &SectionPoint::x);
  const auto most = std::ranges::max_element(high.points(), {}, &SectionPoint::x);
  return most->x - least->x;
}

Status SideLines::stretchTo(double from, double to) {
  const double height = to - from, off = kMostOff * height, first = start(), last = end();
  const double longer = length() / height - 1;
  if (std::abs(longer) > kMostOff) {
    return {Error::ShapeInvalid, "the side outline is " + std::to_string(std::lround(std::abs(longer) * 100)) + " % " +
                                     (longer > 0 ? "longer" : "shorter") + " than the front one"};
  }
  if (std::abs(first - from) > off || std::abs(last - to) > off) {
    return {Error::ShapeInvalid, "the side outline lies beside the front one: align the side picture"};
  }
  low.stretch(first, last, from, to);
  high.stretch(first, last, from, to);
  return Done{};
}

Result<SideLines> sideLinesOf(std::vector<Line> lines, const std::string& name) {
  const bool closed = lines.size() == 1;
  for (Line& line : lines) {
    geometry::dropRepeats(line, 0.0);
    if (closed && line.size() > 1 && line.front() == line.back()) line.pop_back();
    if (line.size() < (closed ? 3u : 2u)) return Error::RegionEmpty;
  }
  if (closed) lines = split(lines.front());
  for (Line& line : lines) {
    if (line.back().y < line.front().y) std::ranges::reverse(line);
  }
  if (meanAcross(lines[0]) > meanAcross(lines[1])) std::swap(lines[0], lines[1]);
  const double length =
      std::max(lines[0].back().y, lines[1].back().y) - std::min(lines[0].front().y, lines[1].front().y);
  const Line outline = outlineOf(lines[0], lines[1]);
  const auto [left, right] = std::ranges::minmax(outline, {}, &SectionPoint::x);
  if (!((right.x - left.x) * length >= geometry::kLeastRegionArea)) return Error::RegionEmpty;
  for (const Line& line : lines) {
    if (!(line.back().y - line.front().y > kMostBack * length)) return Error::RegionEmpty;
  }
  const std::vector<Line> drawn = lines;
  const auto evenOut = [&](double window) {
    for (std::size_t i = 0; i < lines.size(); ++i) lines[i] = evened(drawn[i], window);
    const auto plain = [&](const Line& line) {
      return geometry::simplifiedLine(std::span<const SectionPoint>(line), kSlip * length);
    };
    return isSimple(lines[0], lines[1]) || isSimple(plain(lines[0]), plain(lines[1]));
  };
  if (std::ranges::none_of(kTremor, evenOut)) {
    lines = drawn;  // evened out, the corners of a narrow end may cross
    if (!isSimple(lines[0], lines[1])) {
      return Failure{Error::ShapeInvalid, name + (closed ? " crosses itself" : ": its two lines cross")};
    }
  }
  if (!(std::abs(geometry::signedArea(std::span<const SectionPoint>(outline))) >= geometry::kLeastRegionArea)) {
    return Error::RegionEmpty;
  }
  SideLines sides{SideLine(std::move(lines[0])), SideLine(std::move(lines[1]))};
  const double back = std::max(sides.low.steppedBack(), sides.high.steppedBack());
  if (back > kMostBack * length) {
    return Failure{Error::ShapeInvalid, name + " turns back along the shape: draw a line through the thing instead"};
  }
  return sides;
}

}  // namespace spineloft::shape
