#include "engine/stack/outline.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/sections/drawing.h"

namespace spineloft::stack {
namespace {

using Points = std::vector<SectionPoint>;
using sections::Contour;

constexpr std::array kUseNames = {CurveUseName{CurveUse::Closed, "closed"}, CurveUseName{CurveUse::Ribbon, "ribbon"},
                                  CurveUseName{CurveUse::Ground, "ground"}};
static_assert(kUseNames.size() == static_cast<std::size_t>(CurveUse::kCount));

/// The curve as a line, of an open one with its last point. It is drawn larger, for outlines of sections are coarser
/// than solids of true size want them.
Contour lineOf(const Curve& curve) {
  constexpr double kEnlarged = 32;  // section units: the outline is within a ten-thousandth of half the size
  SectionPoint low{kFarOut, kFarOut}, high{-kFarOut, -kFarOut};
  for (const SectionPoint p : curve.through) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double scale = 2 * kEnlarged / std::max(high.x - low.x, high.y - low.y);
  const SectionPoint middle = (low + high) / 2;
  sections::DrawnCurve drawn;
  for (const SectionPoint p : curve.through) drawn.points.push_back({(p - middle) * scale, curve.corners.all});
  for (const std::uint32_t i : curve.corners.at) drawn.points[i].corner = true;
  Contour line;
  for (std::size_t i = 0; i + (curve.open ? 1 : 0) < drawn.points.size(); ++i) {
    const Points stretch = curve.open ? sections::openStretchOf(drawn, i) : sections::stretchOf(drawn, i);
    for (std::size_t k = 0; k + 1 < stretch.size(); ++k) {
      line.points.push_back(k == 0 ? curve.through[i] : middle + stretch[k] / scale);
      line.knot.push_back(k == 0 && drawn.points[i].corner);
    }
  }
  if (curve.open) {  // where the outline leaves it
    line.points.push_back(curve.through.back());
    line.knot.push_back(true);
    line.knot.front() = true;
  }
  return line;
}

/// Appends the points to the left of the line at `i` that keep `reach` from both segments there.
void addBeside(const Contour& line, std::size_t i, double reach, Contour& out) {
  const std::size_t last = line.points.size() - 1;
  const auto leftOf = [&](std::size_t a) {
    const SectionPoint along = normalized(line.points[a + 1] - line.points[a]);
    return SectionPoint{-along.y, along.x};
  };
  const SectionPoint before = leftOf(i > 0 ? i - 1 : 0), after = leftOf(i < last ? i : last - 1);
  const auto add = [&](SectionPoint way) {
    out.points.push_back(line.points[i] + way * reach);
    out.knot.push_back(line.knot[i]);
  };
  const double share = (1 + dot(before, after)) / 2;  // squared cosine of half the angle
  constexpr double kLeastShare = 1 / (kMostMitre * kMostMitre), kBack = 1e-6;
  const bool inside = cross(before, after) > 0 && share > kBack;
  if (inside || share > kLeastShare) return add((before + after) / (2 * share));
  add(before);
  add(after);
}

Contour ribbonOf(const Contour& line, double width) {
  Contour back = line, out;
  std::ranges::reverse(back.points);
  std::reverse(back.knot.begin(), back.knot.end());
  for (const Contour& side : {line, back}) {
    for (std::size_t i = 0; i < side.points.size(); ++i) addBeside(side, i, width / 2, out);
  }
  return out;
}

Contour groundOf(Contour line, double base) {
  const SectionPoint first = line.points.front(), last = line.points.back();
  for (const SectionPoint foot : {last, first}) {
    if (foot.y == base) continue;  // the line begins or ends on the ground
    line.points.push_back({foot.x, base});
    line.knot.push_back(true);
  }
  return line;
}

}  // namespace

std::span<const CurveUseName> curveUseNames() { return kUseNames; }

Contour polygonOf(const Curve& curve) {
  Contour line = lineOf(curve);
  if (!curve.open) return line;
  return curve.as == CurveUse::Ribbon ? ribbonOf(line, curve.width) : groundOf(std::move(line), curve.base);
}

std::string lackOf(const Curve& curve) {
  if (curve.open && curve.as == CurveUse::Closed) return "is open: make it a ribbon or ground, or close it";
  if (!curve.open && curve.as != CurveUse::Closed)
    return "is closed, and only open ones are ribbons or ground: open it";
  if (curve.as == CurveUse::Ribbon && !(curve.width > 0)) return "is a ribbon without a width: give it one above 0";
  return {};
}

}  // namespace spineloft::stack
