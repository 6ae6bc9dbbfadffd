#include "engine/sections/drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "engine/geometry/polygon.h"
#include "engine/geometry/polyline.h"
#include "engine/sections/curve.h"
#include "engine/sections/open_line.h"
#include "engine/sections/symmetry.h"

namespace spineloft::sections {
namespace {

constexpr double kSpacing = 0.012;  ///< between the samples of a stroke, section units
constexpr std::size_t kMostSamples = 1200;
constexpr double kTail = 0.35;       ///< share of a stroke at either end that may run past the other
constexpr double kClosedGap = 0.12;  ///< ends nearer than this share of the length are joined
constexpr double kFarthest = 100;    ///< section units; strokes beyond it are a mistake
/// Tremor of a drawn line: an amplitude of one or two hundredths of the square, over some four hundredths.
constexpr FitParams kFreehand{kFitTolerance, 0.09, 0.9, 16};
constexpr FitParams kExact{0.004, 0.05, 0.45, 0};

using Line = std::vector<SectionPoint>;
using View = std::span<const SectionPoint>;

/// Where segments a→b and c→d cross, as shares of the two.
std::optional<std::pair<double, double>> crossingOf(SectionPoint a, SectionPoint b, SectionPoint c, SectionPoint d) {
  const SectionPoint u = b - a, v = d - c, w = c - a;
  const double det = cross(u, v);
  if (det == 0) return std::nullopt;
  const double s = cross(w, v) / det, t = cross(w, u) / det;
  if (!(s >= 0 && s <= 1 && t >= 0 && t <= 1)) return std::nullopt;
  return std::pair{s, t};
}

/// Cuts off what runs past a crossing of the line's first and last part. True when there is one:
/// the line is closed then.
bool cutTails(Line& line) {
  const auto tail = static_cast<std::size_t>(static_cast<double>(line.size()) * kTail);
  std::size_t bestCost = line.size(), first = 0, last = 0;
  SectionPoint at;
  for (std::size_t i = 0; i + 1 < tail; ++i) {
    for (std::size_t back = 0; back + 1 < tail && i + back < bestCost; ++back) {
      const std::size_t j = line.size() - 2 - back;
      if (j <= i + 1) break;
      const auto hit = crossingOf(line[i], line[i + 1], line[j], line[j + 1]);
      if (!hit) continue;
      bestCost = i + back;
      first = i;
      last = j;
      at = lerp(line[i], line[i + 1], hit->first);
    }
  }
  if (bestCost == line.size()) return false;
  Line cut{at};
  cut.insert(cut.end(), line.begin() + static_cast<std::ptrdiff_t>(first) + 1,
             line.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  line = geometry::dropRepeats(View(cut), kSpacing / 10);
  return true;
}

/// Samples from the last point to the first, which are then one step apart.
void close(Line& line) {
  const SectionPoint from = line.back(), to = line.front();
  const int steps = static_cast<int>(std::ceil(distance(from, to) / kSpacing));
  for (int i = 1; i < steps; ++i) line.push_back(lerp(from, to, static_cast<double>(i) / steps));
}

DrawnCurve moved(const DrawnCurve& curve, const Motion& motion) {
  DrawnCurve out = curve;
  for (DrawnPoint& p : out.points) p.at = motion(p.at);
  return out;
}

Drawing curvesOf(const Repeated& repeated, const FitParams& params) {
  Drawing out;
  for (const Chain& chain : repeated.chains) {
    const DrawnCurve curve = fitCurve(chain, params);
    for (const Motion& motion : repeated.copies) out.push_back(moved(curve, motion));
  }
  return out;
}

/// The distinct points of a line. Errors: StrokeNotFinite, SectionInvalid.
Result<Line> distinct(View line, double apart) {
  for (const SectionPoint p : line) {
    if (!isFinite(p) || std::abs(p.x) > kFarthest || std::abs(p.y) > kFarthest) {
      return Error::StrokeNotFinite;
    }
  }
  if (line.size() >= 3) {
    Line points = geometry::dropRepeats(line, apart);
    if (points.size() >= 3) return points;
  }
  return {Error::SectionInvalid, std::string(sentenceOf(DrawingFault::TooSmall))};
}

/// Sampled at kSpacing. ≥ 2 points.
Line evenly(const Line& line) {
  const double length = geometry::arcLengths(View(line)).back();
  const auto samples = static_cast<std::size_t>(std::ceil(length / kSpacing)) + 1;
  return geometry::resample(View(line), std::clamp<std::size_t>(samples, 8, kMostSamples));
}

/// The outlines of a drawing, and how they lie in each other.
struct Outlines {
  std::vector<Line> lines;
  explicit Outlines(std::vector<Line> closed) : lines(std::move(closed)) {}
  explicit Outlines(const Drawing& drawing) {
    for (const DrawnCurve& curve : drawing) lines.push_back(outlineOf(curve));
  }
  /// How many others hold line i.
  int depth(std::size_t i) const {
    int count = 0;
    for (std::size_t j = 0; j < lines.size(); ++j) {
      if (j != i && geometry::holds(View(lines[j]), lines[i].front())) ++count;
    }
    return count;
  }
};

struct Bounds {
  SectionPoint low{1e300, 1e300}, high{-1e300, -1e300};
  void add(View points) {
    for (const SectionPoint p : points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  SectionPoint size() const { return high - low; }
};

bool tooSmall(View outline) {
  if (outline.size() < 3) return true;
  Bounds bounds;
  bounds.add(outline);
  return bounds.size().x < kLeastWidth || bounds.size().y < kLeastWidth / 4 ||
         std::abs(geometry::signedArea(outline)) < kLeastArea;
}

std::optional<DrawingProblem> problemOf(const Outlines& outlines) {
  const auto& lines = outlines.lines;
  if (lines.empty()) return DrawingProblem{DrawingFault::Empty, 0};
  if (lines.size() > kMostContours) return DrawingProblem{DrawingFault::TooMany, kMostContours};
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].size() > kMostDrawnPoints) return DrawingProblem{DrawingFault::TooMany, i};
    const bool simple = geometry::isSimple(View(lines[i]));
    if (lines[i].size() >= 3 && !simple) return DrawingProblem{DrawingFault::CrossesItself, i};
    if (tooSmall(lines[i])) return DrawingProblem{DrawingFault::TooSmall, i};
  }
  for (std::size_t i = 1; i < lines.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (outlinesMeet(lines[i], lines[j])) return DrawingProblem{DrawingFault::CurvesCross, i};
    }
  }
  return std::nullopt;
}

/// Scales and shifts so that the whole touches x = ±1 and lies between y = ±1.
void fitSquare(std::vector<Line>& lines) {
  Bounds bounds;
  for (const Line& line : lines) bounds.add(line);
  const double middle = (bounds.low.x + bounds.high.x) / 2, half = bounds.size().x / 2;
  double scale = 1 / half, shift = 0;
  const double low = bounds.low.y * scale, high = bounds.high.y * scale;
  if (low < -1 || high > 1) {
    const double tall = high - low;
    if (tall > 2) scale *= 2 / tall;
    // As little as brings it inside.
    const double by = tall > 2 ? 2 / tall : 1;
    shift = std::max(0.0, -1 - low * by) - std::max(0.0, high * by - 1);
  }
  for (Line& line : lines) {
    for (SectionPoint& p : line) {
      const double x = (p.x - middle) / half;
      p = {std::clamp(x, -1.0, 1.0), std::clamp(p.y * scale + shift, -1.0, 1.0)};
      if (std::abs(std::abs(x) - 1) < 1e-9) p.x = std::copysign(1.0, x);
    }
  }
}

/// The outlines as drawn: what lies in an odd number of others goes round the other way and comes last.
Result<SectionShape> nestedShape(const Outlines& outlines) {
  if (const auto problem = problemOf(outlines)) {
    return {Error::SectionInvalid, std::string(sentenceOf(problem->fault))};
  }
  std::vector<std::pair<int, Line>> nested;
  for (std::size_t i = 0; i < outlines.lines.size(); ++i) {
    nested.emplace_back(outlines.depth(i), outlines.lines[i]);
  }
  std::ranges::stable_sort(nested, {}, [](const auto& entry) { return entry.first % 2; });
  SectionShape shape;
  for (auto& [depth, line] : nested) {
    const bool hole = depth % 2 != 0;
    if ((geometry::signedArea(View(line)) < 0) != hole) std::ranges::reverse(line);
    shape.contours.push_back(std::move(line));
  }
  return shape;
}

}  // namespace

std::vector<SectionPoint> images(SectionPoint p, const Symmetry& symmetry) {
  std::vector<SectionPoint> out;
  for (const Motion& motion : groupOf(symmetry).motions()) out.push_back(motion(p));
  return out;
}

Result<Drawing> drawFreehand(std::span<const SectionPoint> stroke, const Symmetry& symmetry) {
  Result<Line> points = distinct(stroke, 1e-4);
  if (!points) return points.failure();
  Line line = evenly(points.value());
  const double length = geometry::arcLengths(View(line)).back();
  bool closed = cutTails(line);
  const double gap = distance(line.front(), line.back());
  closed = closed || symmetry.none() || gap < kClosedGap * length;
  if (closed) close(line);
  if (line.size() < 4) {
    return {Error::SectionInvalid, std::string(sentenceOf(DrawingFault::TooSmall))};
  }
  return curvesOf(repeat(line, closed, kSpacing, symmetry), kFreehand);
}

Result<DrawnCurve> drawOpenLine(std::span<const SectionPoint> stroke) {
  Result<Line> points = distinct(stroke, 1e-4);
  if (!points) return points.failure();
  const Line line = evenly(points.value());
  return fitCurve({line, line.size(), false, true}, kFreehand);
}

Result<Drawing> drawOutline(std::span<const SectionPoint> polygon, const Symmetry& symmetry) {
  Result<Line> points = distinct(polygon, 1e-9);
  if (!points) return points.failure();
  Line corners = std::move(points).value();
  if (distance(corners.front(), corners.back()) <= 1e-9) corners.pop_back();
  double length = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    length += distance(corners[i], corners[(i + 1) % corners.size()]);
  }
  const double spacing = std::max(kSpacing, length / static_cast<double>(kMostSamples));
  Line line;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const SectionPoint from = corners[i], to = corners[(i + 1) % corners.size()];
    const int steps = std::max(1, static_cast<int>(std::ceil(distance(from, to) / spacing)));
    for (int k = 0; k < steps; ++k) line.push_back(lerp(from, to, static_cast<double>(k) / steps));
  }
  return curvesOf(repeat(line, true, spacing, symmetry), kExact);
}

DrawnCurve polygonCurve(std::span<const SectionPoint> corners) {
  DrawnCurve curve;
  for (const SectionPoint p : corners) curve.points.push_back({p, true});
  return curve;
}

DrawnCurve boxCurve(SectionPoint a, SectionPoint b) {
  const SectionPoint low{std::min(a.x, b.x), std::min(a.y, b.y)};
  const SectionPoint high{std::max(a.x, b.x), std::max(a.y, b.y)};
  return polygonCurve(std::array{SectionPoint{high.x, low.y}, high, SectionPoint{low.x, high.y}, low});
}

DrawnCurve ellipseCurve(SectionPoint a, SectionPoint b) {
  constexpr int kPoints = 12;
  const SectionPoint middle = (a + b) * 0.5, radius = (b - a) * 0.5;
  DrawnCurve curve;
  // The first quarter, mirrored, so that opposite points are exactly opposite.
  for (int i = 0; i < kPoints; ++i) {
    const int quarter = i / 3, k = i % 3;
    const double angle = std::numbers::pi / 6 * k;
    const SectionPoint unit{k == 0 ? 1.0 : std::cos(angle), k == 0 ? 0.0 : std::sin(angle)};
    const std::array<SectionPoint, 4> turnedUnit{unit, {-unit.y, unit.x}, -unit, {unit.y, -unit.x}};
    const SectionPoint p = turnedUnit[static_cast<std::size_t>(quarter)];
    curve.points.push_back({{middle.x + p.x * std::abs(radius.x), middle.y + p.y * std::abs(radius.y)}, false});
  }
  return curve;
}

Result<Drawing> drawingOf(const SectionShape& shape) {
  constexpr int kPresetPoints = 180;
  std::vector<Line> lines = shape.contours;
  if (!shape.drawn()) {
    Result<Section> preset = presetSection(shape.preset, kPresetPoints);
    if (!preset) return preset.failure();
    lines = {std::move(preset).value().points};
  }
  Drawing drawing;
  for (const Line& line : lines) {
    Result<Drawing> curves = drawOutline(line, {});
    if (!curves) return curves.failure();
    drawing.insert(drawing.end(), curves.value().begin(), curves.value().end());
  }
  return drawing;
}

Drawing symmetric(const Drawing& drawing, const Symmetry& symmetry) {
  if (symmetry.none()) return drawing;
  Drawing out;
  std::vector<Line> there;
  for (const DrawnCurve& curve : drawing) {
    const Result<Drawing> curves = drawOutline(outlineOf(curve), symmetry);
    if (!curves) {
      out.push_back(curve);
      continue;
    }
    const std::size_t before = there.size();
    for (const DrawnCurve& image : curves.value()) {
      Line line = outlineOf(image);
      const bool free = std::none_of(there.begin(), there.begin() + static_cast<std::ptrdiff_t>(before),
                                     [&](const Line& other) { return outlinesMeet(line, other); });
      if (!free) continue;
      out.push_back(image);
      there.push_back(std::move(line));
    }
  }
  return out;
}

Drawing turned(const Drawing& drawing, Turn turn) {
  Drawing out = drawing;
  for (DrawnCurve& curve : out) {
    for (DrawnPoint& p : curve.points) {
      switch (turn) {
        case Turn::FlipLeftRight:
          p.at.x = -p.at.x;
          break;
        case Turn::FlipFrontBack:
          p.at.y = -p.at.y;
          break;
        case Turn::QuarterTurn:
          p.at = {-p.at.y, p.at.x};
          break;
      }
    }
  }
  return out;
}

bool outlinesMeet(std::span<const SectionPoint> a, std::span<const SectionPoint> b) {
  Bounds boundsA, boundsB;
  boundsA.add(a);
  boundsB.add(b);
  if (boundsA.high.x < boundsB.low.x || boundsB.high.x < boundsA.low.x || boundsA.high.y < boundsB.low.y ||
      boundsB.high.y < boundsA.low.y) {
    return false;
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    const SectionPoint p = a[i], q = a[(i + 1) % a.size()];
    Bounds edge;
    edge.add(std::array{p, q});
    for (std::size_t j = 0; j < b.size(); ++j) {
      const SectionPoint r = b[j], s = b[(j + 1) % b.size()];
      if (std::max(r.x, s.x) < edge.low.x || std::min(r.x, s.x) > edge.high.x || std::max(r.y, s.y) < edge.low.y ||
          std::min(r.y, s.y) > edge.high.y) {
        continue;
      }
      if (p == r || crossingOf(p, q, r, s)) return true;
    }
  }
  return false;
}

std::optional<DrawingProblem> problemOf(const Drawing& drawing) { return problemOf(Outlines(drawing)); }

std::string_view sentenceOf(DrawingFault fault) {
  switch (fault) {
    case DrawingFault::Empty:
      return "Draw a closed curve: that is the slice.";
    case DrawingFault::TooSmall:
      return "This curve is too small or too thin. Draw it larger, or take it away.";
    case DrawingFault::CrossesItself:
      return "This curve crosses itself. Drag its points apart, or draw it again.";
    case DrawingFault::CurvesCross:
      return "Two curves cross. Move one of them, or take one away.";
    case DrawingFault::TooMany:
      return "That is more than a slice can hold: 16 curves. Take some away.";
  }
  return {};
}

Result<SectionShape> sectionOf(const Drawing& drawing) { return sectionOfOutlines(Outlines(drawing).lines); }

Result<SectionShape> sectionOfOutlines(std::vector<std::vector<SectionPoint>> lines) {
  Result<SectionShape> shape = nestedShape(Outlines(std::move(lines)));
  if (!shape) return shape;
  fitSquare(shape.value().contours);
  if (Status status = checkShape(shape.value()); !status) return status.failure();
  return shape;
}

Result<SectionShape> profileOf(const Drawing& drawing) {
  Outlines outlines(drawing);
  for (Line& line : outlines.lines) {
    for (SectionPoint& p : line) p = {std::clamp(p.x, -1.0, 1.0), std::clamp(p.y, -1.0, 1.0)};
  }
  Result<SectionShape> shape = nestedShape(Outlines(std::move(outlines.lines)));
  if (!shape) return shape;
  if (Status status = checkShape(shape.value()); !status) return status.failure();
  return shape;
}

}  // namespace spineloft::sections
