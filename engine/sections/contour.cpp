#include "engine/sections/contour.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "engine/geometry/polygon.h"
#include "engine/geometry/polyline.h"

namespace spineloft::sections {
namespace {

using Curve = std::vector<SectionPoint>;

Failure refused(const char* why) { return {Error::SectionInvalid, why}; }

/// Without points that repeat their predecessor; the first is not repeated at the end.
Curve withoutRepeats(const Curve& drawn) {
  constexpr double kSame = 1e-7;  // section units
  Curve curve;
  curve.reserve(drawn.size());
  for (const SectionPoint& p : drawn) {
    if (curve.empty() || distance(curve.back(), p) > kSame) curve.push_back(p);
  }
  while (curve.size() > 1 && distance(curve.back(), curve.front()) <= kSame) curve.pop_back();
  return curve;
}

bool areSimple(const std::vector<Curve>& curves) {
  Curve all;
  std::vector<std::size_t> sizes;
  for (const Curve& curve : curves) {
    all.insert(all.end(), curve.begin(), curve.end());
    sizes.push_back(curve.size());
  }
  return geometry::areSimple(all, sizes);
}

/// What was drawn, without repeats, or why it cannot be used.
Result<std::vector<Curve>> readCurves(const SectionShape& shape) {
  if (shape.contours.size() > kMostContours) return refused("more than 16 closed curves");
  std::vector<Curve> curves;
  std::size_t total = 0;
  for (const Curve& drawn : shape.contours) {
    total += drawn.size();
    if (drawn.size() > kMostDrawnPoints || total > 2 * kMostDrawnPoints) {
      return refused("a curve has more than 5000 points");
    }
    for (const SectionPoint& p : drawn) {
      constexpr double kFarOut = 1e6;
      if (!isFinite(p) || std::abs(p.x) > kFarOut || std::abs(p.y) > kFarOut) {
        return refused("a point has no place");
      }
    }
    curves.push_back(withoutRepeats(drawn));
    if (curves.back().size() < 3) return refused("a closed curve needs three different points");
  }
  return curves;
}

/// Scaled evenly and moved along x, so that all curves together touch x = ±1. False when they have
/// no width.
bool fitWidth(std::vector<Curve>& curves) {
  constexpr double kThin = 1e-3, kClose = 1e-9;
  double low = curves[0][0].x, high = low, deep = 0;
  for (const Curve& curve : curves) {
    for (const SectionPoint& p : curve) {
      low = std::min(low, p.x);
      high = std::max(high, p.x);
    }
  }
  if (!(high - low > kThin)) return false;
  const bool fits = std::abs(low + 1) < kClose && std::abs(high - 1) < kClose;
  const double scale = fits ? 1 : 2 / (high - low), middle = fits ? 0 : (low + high) / 2;
  for (Curve& curve : curves) {
    for (SectionPoint& p : curve) {
      p = {(p.x - middle) * scale, p.y * scale};
      if (std::abs(std::abs(p.x) - 1) < kClose) p.x = std::copysign(1.0, p.x);
      deep = std::max(deep, std::abs(p.y));
    }
  }
  if (deep > kDeepest) {
    for (Curve& curve : curves) {
      for (SectionPoint& p : curve) p.y *= kDeepest / deep;
    }
  }
  return true;
}

/// All curves simplified as far as they stay simple and apart.
std::vector<Curve> simplified(const std::vector<Curve>& curves) {
  for (double tolerance = kSmallest; tolerance > kSmallest / 100; tolerance /= 3) {
    std::vector<Curve> out;
    for (const Curve& curve : curves) out.push_back(geometry::simplified(curve, tolerance));
    if (areSimple(out)) return out;
  }
  return curves;
}

/// Which points turn by more than kCorner, and those farthest left and right.
Contour contourOf(Curve curve) {
  constexpr double kCorner = 25 * std::numbers::pi / 180;
  Contour contour;
  const std::size_t n = curve.size();
  contour.knot.assign(n, false);
  for (std::size_t i = 0; i < n; ++i) {
    const SectionPoint in = curve[i] - curve[(i + n - 1) % n], out = curve[(i + 1) % n] - curve[i];
    contour.knot[i] = std::abs(std::atan2(cross(in, out), dot(in, out))) > kCorner;
  }
  const auto [left, right] = std::ranges::minmax_element(curve, {}, &SectionPoint::x);
  contour.knot[static_cast<std::size_t>(left - curve.begin())] = true;
  contour.knot[static_cast<std::size_t>(right - curve.begin())] = true;
  contour.points = std::move(curve);
  return contour;
}

}  // namespace

void nest(std::vector<SectionPiece>& pieces) {
  std::vector<double> areas;
  for (const SectionPiece& piece : pieces) {
    areas.push_back(geometry::signedArea(std::span<const SectionPoint>(piece.contour.points)));
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < pieces.size(); ++j) {
      const std::span<const SectionPoint> other(pieces[j].contour.points);
      if (i == j || areas[j] < areas[i] || !geometry::holds(other, pieces[i].contour.points.front())) continue;
      pieces[i].hole = !pieces[i].hole;
      if (areas[j] < least) {
        least = areas[j];
        pieces[i].outer = j;
      }
    }
  }
}

Result<std::vector<SectionPiece>> readShape(const SectionShape& shape) {
  if (!shape.drawn()) {
    if (shape.preset >= SectionPreset::kCount) return Failure{Error::ValueOutOfRange, "slice"};
    constexpr int kFine = 256;
    return std::vector<SectionPiece>{{presetContour(shape.preset, kFine), false, 0}};
  }
  Result<std::vector<Curve>> read = readCurves(shape);
  if (!read) return read.failure();
  std::vector<Curve> curves = std::move(read).value();
  if (!fitWidth(curves)) return refused("it has no width");
  if (!areSimple(curves)) return refused("a curve crosses or touches itself or another one");
  curves = simplified(curves);
  std::vector<SectionPiece> pieces(curves.size());
  std::size_t total = 0;
  for (Curve& curve : curves) {
    constexpr double kSliver = 1e-5;  // square section units
    const double area = geometry::signedArea(std::span<const SectionPoint>(curve));
    if (!(std::abs(area) > kSliver)) return refused("a curve encloses nothing");
    if (area < 0) std::ranges::reverse(curve);
    total += curve.size();
  }
  if (total > kMostShapePoints) return refused("the curves have too much fine detail");
  for (std::size_t i = 0; i < curves.size(); ++i) {
    pieces[i].contour = contourOf(std::move(curves[i]));
  }
  nest(pieces);
  return pieces;
}

}  // namespace spineloft::sections
