#include "engine/sections/section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/sections/contour.h"

namespace spineloft::sections {
namespace {

constexpr double kPi = std::numbers::pi;

constexpr std::array kNames = {
    SectionName{SectionPreset::Circle, "circle", "Circle"},
    SectionName{SectionPreset::Ellipse, "ellipse", "Ellipse"},
    SectionName{SectionPreset::Square, "square", "Square"},
    SectionName{SectionPreset::RoundedSquare, "rounded-square", "Rounded square"},
    SectionName{SectionPreset::Triangle, "triangle", "Triangle"},
    SectionName{SectionPreset::Hexagon, "hexagon", "Hexagon"},
    SectionName{SectionPreset::Star, "star", "Star"},
    SectionName{SectionPreset::HalfRound, "half-round", "Half round"},
    SectionName{SectionPreset::D, "d", "D"},
    SectionName{SectionPreset::Heart, "heart", "Heart"},
    SectionName{SectionPreset::Plank, "plank", "Plank"},
    SectionName{SectionPreset::Gear, "gear", "Gear"},
};
static_assert(kNames.size() == static_cast<std::size_t>(SectionPreset::kCount));

/// A straight or elliptic stretch of an outline; its ends are always kept.
struct Piece {
  SectionPoint from, to;            ///< lines
  SectionPoint centre;              ///< arcs
  double rx = 0, ry = 0;            ///< arcs: radii; both 0 for a line
  double startAngle = 0, turn = 0;  ///< arcs, radians, counter-clockwise when positive

  bool isLine() const { return rx == 0; }
  SectionPoint at(double t) const {
    if (isLine()) return lerp(from, to, t);
    const double angle = startAngle + turn * t;
    return {centre.x + rx * std::cos(angle), centre.y + ry * std::sin(angle)};
  }
  double length() const {
    if (isLine()) return distance(from, to);
    constexpr int kChords = 8;
    double sum = 0;
    SectionPoint last = at(0);
    for (int i = 1; i <= kChords; ++i) {
      const SectionPoint next = at(static_cast<double>(i) / kChords);
      sum += distance(last, next);
      last = next;
    }
    return sum;
  }
};

using Outline = std::vector<Piece>;

Piece line(SectionPoint from, SectionPoint to) {
  Piece piece;
  piece.from = from;
  piece.to = to;
  return piece;
}

Piece arc(SectionPoint centre, SectionPoint radii, double startAngle, double turn) {
  Piece piece;
  piece.centre = centre;
  piece.rx = radii.x;
  piece.ry = radii.y;
  piece.startAngle = startAngle;
  piece.turn = turn;
  return piece;
}

Outline polygon(const std::vector<SectionPoint>& corners) {
  Outline outline;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    outline.push_back(line(corners[i], corners[(i + 1) % corners.size()]));
  }
  return outline;
}

/// In quarters, so that the extremes x = ±1 are always points.
Outline ellipse(double ry) {
  Outline outline;
  for (int quarter = 0; quarter < 4; ++quarter) {
    outline.push_back(arc({0, 0}, {1, ry}, quarter * kPi / 2, kPi / 2));
  }
  return outline;
}

Outline roundedBox(double halfHeight, double radius) {
  const double x = 1 - radius, y = halfHeight - radius;
  return {line({1, -y}, {1, y}),
          arc({x, y}, {radius, radius}, 0, kPi / 2),
          line({x, halfHeight}, {-x, halfHeight}),
          arc({-x, y}, {radius, radius}, kPi / 2, kPi / 2),
          line({-1, y}, {-1, -y}),
          arc({-x, -y}, {radius, radius}, kPi, kPi / 2),
          line({-x, -halfHeight}, {x, -halfHeight}),
          arc({x, -y}, {radius, radius}, 3 * kPi / 2, kPi / 2)};
}

Outline star() {
  constexpr int kTips = 5;
  constexpr double kInner = 0.46;                          // of the tips' radius: plump, not spiky
  const double tip = 1 / std::cos(kPi / 10);               // so that the two side tips reach x = ±1
  const double shift = tip * (std::cos(kPi / 5) - 1) / 2;  // as far up as down
  std::vector<SectionPoint> corners;
  for (int i = 0; i < 2 * kTips; ++i) {
    const double angle = kPi / 10 + i * kPi / kTips;
    const double radius = i % 2 == 0 ? tip : tip * kInner;
    corners.push_back({radius * std::cos(angle), radius * std::sin(angle) + shift});
  }
  return polygon(corners);
}

/// Two round lobes towards the viewer, straight flanks that touch them, a point at the back.
Outline heart() {
  constexpr double kRadius = 0.53, kLobe = 1 - kRadius, kUp = 0.4, kTip = -0.95;
  const double dent = std::acos(kLobe / kRadius);  // where the right lobe meets the axis: π − dent
  // The flank from the tip touches the right lobe at angle −touch below the x axis.
  const double toTip = std::atan2(kTip - kUp, -kLobe);
  const double reach = std::hypot(kLobe, kUp - kTip);
  const double touch = toTip + std::acos(kRadius / reach);  // right lobe, negative
  const SectionPoint right{kLobe, kUp}, left{-kLobe, kUp}, radii{kRadius, kRadius}, tip{0, kTip};
  Outline outline = {
      arc(right, radii, 0, kPi - dent), arc(left, radii, dent, kPi - dent), arc(left, radii, kPi, -touch), {}, {},
      arc(right, radii, touch, -touch)};
  outline[3] = line(outline[2].at(1), tip);
  outline[4] = line(tip, outline[5].at(0));
  return outline;
}

Outline gear() {
  constexpr int kTeeth = 10;
  constexpr double kTop = 0.13, kFoot = 0.2;  // half angles of a tooth's land and foot, radians
  constexpr double kRoot = 0.74;
  const double top = 1 / std::cos(kTop);  // the flat lands of the side teeth lie on x = ±1
  std::vector<SectionPoint> corners;
  for (int tooth = 0; tooth < kTeeth; ++tooth) {
    const double angle = tooth * 2 * kPi / kTeeth;
    const auto put = [&](double radius, double offset) {
      corners.push_back({radius * std::cos(angle + offset), radius * std::sin(angle + offset)});
    };
    put(kRoot, -kFoot);
    put(top, -kTop);
    put(top, kTop);
    put(kRoot, kFoot);
  }
  return polygon(corners);
}

Outline outlineOf(SectionPreset preset) {
  switch (preset) {
    case SectionPreset::Circle:
      return ellipse(1);
    case SectionPreset::Ellipse:
      return ellipse(0.5);
    case SectionPreset::Square:
      return polygon({{1, -1}, {1, 1}, {-1, 1}, {-1, -1}});
    case SectionPreset::RoundedSquare:
      return roundedBox(1, 0.4);
    case SectionPreset::Triangle: {
      // Equilateral, standing on its back, an edge towards the viewer.
      const double height = std::sqrt(3.0);
      return polygon({{1, -height / 2}, {0, height / 2}, {-1, -height / 2}});
    }
    case SectionPreset::Hexagon: {
      const double y = std::sqrt(3.0) / 2;
      return polygon({{1, 0}, {0.5, y}, {-0.5, y}, {-1, 0}, {-0.5, -y}, {0.5, -y}});
    }
    case SectionPreset::Star:
      return star();
    case SectionPreset::HalfRound:
      // The flat back lies on y = 0, so that it stays flat however the width changes.
      return {arc({0, 0}, {1, 1}, 0, kPi / 2), arc({0, 0}, {1, 1}, kPi / 2, kPi / 2), line({-1, 0}, {1, 0})};
    case SectionPreset::D:
      return {arc({-1, 0}, {2, 1}, -kPi / 2, kPi / 2), arc({-1, 0}, {2, 1}, 0, kPi / 2), line({-1, 1}, {-1, -1})};
    case SectionPreset::Heart:
      return heart();
    case SectionPreset::Plank:
      return roundedBox(0.18, 0.12);
    case SectionPreset::Gear:
      return gear();
    case SectionPreset::kCount:
      break;
  }
  return {};
}

}  // namespace

std::span<const SectionName> sectionNames() { return kNames; }

std::optional<SectionPreset> sectionFromKey(std::string_view key) {
  for (const SectionName& name : kNames) {
    if (name.key == key) return name.preset;
  }
  return std::nullopt;
}

std::string_view sectionKey(SectionPreset preset) {
  for (const SectionName& name : kNames) {
    if (name.preset == preset) return name.key;
  }
  return {};
}

Contour presetContour(SectionPreset preset, int count) {
  const Outline outline = outlineOf(preset);
  double total = 0;
  for (const Piece& piece : outline) total += piece.length();
  Contour contour;
  contour.points.reserve(static_cast<std::size_t>(count) + outline.size());
  for (const Piece& piece : outline) {
    const int steps = std::max(1, static_cast<int>(std::lround(piece.length() / total * count)));
    for (int i = 0; i < steps; ++i) {
      SectionPoint p = piece.at(static_cast<double>(i) / steps);
      // Rounding must not keep the outline from touching the rib's ends.
      constexpr double kRounding = 1e-12;
      if (std::abs(std::abs(p.x) - 1) < kRounding) p.x = std::copysign(1.0, p.x);
      if (std::abs(p.x) < kRounding) p.x = 0;
      if (std::abs(p.y) < kRounding) p.y = 0;
      contour.points.push_back(p);
      contour.knot.push_back(i == 0);
    }
  }
  return contour;
}

Result<Section> presetSection(SectionPreset preset, int count) {
  if (count < kMinSectionPoints || count > kMaxSectionPoints) {
    return {Error::ValueOutOfRange, "section points"};
  }
  if (preset >= SectionPreset::kCount) return {Error::ValueOutOfRange, "section"};
  return Section{presetContour(preset, count).points};
}

Status checkShape(const SectionShape& shape) {
  if (shape.preset >= SectionPreset::kCount) return {Error::ValueOutOfRange, "slice"};
  if (!shape.drawn()) return Done{};
  const Result<std::vector<SectionPiece>> pieces = readShape(shape);
  if (!pieces) return pieces.failure();
  return Done{};
}

}  // namespace spineloft::sections
