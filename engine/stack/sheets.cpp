#include "engine/stack/sheets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "engine/geometry/polygon.h"
#include "engine/geometry/polyline.h"
#include "engine/stack/outline.h"

namespace spineloft::stack {
namespace {

using Points = std::vector<SectionPoint>;

struct Box2 {
  SectionPoint low{kFarOut, kFarOut}, high{-kFarOut, -kFarOut};
  void add(const Points& points) {
    for (const SectionPoint p : points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  double size() const { return std::max(high.x - low.x, high.y - low.y); }
};

void reverse(sections::Contour& contour) {
  std::ranges::reverse(contour.points);
  std::reverse(contour.knot.begin(), contour.knot.end());
}

/// With fewer points where there are very many; corners stay.
void simplify(sections::Contour& contour, double size) {
  constexpr std::size_t kMostPoints = 1536;
  for (double tolerance = size * 2e-5; contour.points.size() > kMostPoints; tolerance *= 2) {
    const std::size_t n = contour.points.size();
    std::vector<bool> kept = contour.knot;
    kept[0] = kept[n / 2] = true;
    std::vector<std::size_t> fixed;
    for (std::size_t i = 0; i < n; ++i) {
      if (kept[i]) fixed.push_back(i);
    }
    std::vector<std::array<std::size_t, 2>> spans;
    for (std::size_t k = 0; k < fixed.size(); ++k) {
      spans.push_back({fixed[k], k + 1 < fixed.size() ? fixed[k + 1] : fixed[0] + n});
    }
    geometry::keepFarther(std::span<const SectionPoint>(contour.points), spans, tolerance, kept);
    sections::Contour fewer;
    for (std::size_t i = 0; i < n; ++i) {
      if (!kept[i]) continue;
      fewer.points.push_back(contour.points[i]);
      fewer.knot.push_back(contour.knot[i]);
    }
    if (fewer.points.size() == n) break;
    contour = std::move(fewer);
  }
}

void dropRepeats(Curve& curve, double reach) {
  Curve out = curve;
  out.through.clear();
  out.corners.at.clear();
  const std::size_t n = curve.through.size();
  std::vector<bool> corner(n, false);
  for (const std::uint32_t i : curve.corners.at) corner[i] = true;
  for (std::size_t i = 0; i < n; ++i) {
    const SectionPoint p = curve.through[i];
    if (!out.through.empty() && distance(out.through.back(), p) <= reach) continue;
    if (!curve.open && i + 1 == n && !out.through.empty() && distance(out.through.front(), p) <= reach) continue;
    if (corner[i]) out.corners.at.push_back(static_cast<std::uint32_t>(out.through.size()));
    out.through.push_back(p);
  }
  curve = std::move(out);
}

/// The outline of a curve counter-clockwise, or why it cannot be used, to follow its name.
Result<sections::Contour> readCurve(Curve curve) {
  constexpr double kNothing = 1e-6, kSliver = 1e-5;  // px; share of the size squared
  const auto refused = [](std::string why) { return Failure{Error::StackInvalid, std::move(why)}; };
  if (std::string lack = lackOf(curve); !lack.empty()) return refused(std::move(lack));
  Box2 box;
  box.add(curve.through);
  if (!(box.size() > kNothing)) return refused("has no size: draw it anew");
  dropRepeats(curve, box.size() * kNothing);
  if (curve.through.size() < (curve.open ? 2u : 3u)) return refused("needs three different points");
  sections::Contour contour = polygonOf(curve);
  if (curve.open) {
    box = {};
    box.add(contour.points);
  }
  if (curve.as == CurveUse::Ground && box.low.y < curve.base) {
    return refused("goes below its base: lower the base, or draw higher");
  }
  simplify(contour, box.size());
  const std::span<const SectionPoint> points(contour.points);
  const double area = geometry::signedArea(points);
  const bool isWide = std::min(box.high.x - box.low.x, box.high.y - box.low.y) > kSliver * box.size();
  if (isWide && !geometry::isSimple(points)) {
    if (curve.as == CurveUse::Ribbon) return refused("bends tighter than its width: make the ribbon narrower");
    if (curve.as == CurveUse::Ground) return refused("crosses itself or the way down to its base: draw it anew");
    return refused("crosses itself: draw it anew");
  }
  if (!(std::abs(area) > kSliver * box.size() * box.size())) {
    return refused(curve.as == CurveUse::Ribbon ? "is too thin: make the ribbon wider"
                                                : "encloses nothing: draw it wider");
  }
  if (area < 0) reverse(contour);
  return contour;
}

/// The curves of a plane as pieces, or which of them cannot be used.
Result<std::vector<sections::SectionPiece>> readCurves(const Plane& plane, const Standing& standing) {
  std::vector<sections::SectionPiece> pieces;
  Points all;
  std::vector<std::size_t> sizes;
  for (std::size_t c = 0; c < plane.curves.size(); ++c) {
    Result<sections::Contour> read = readCurve(plane.curves[c]);
    if (!read) {
      return Failure{Error::StackInvalid,
                     "curve " + std::to_string(c + 1) + " on " + nameOf(standing) + " " + read.failure().detail};
    }
    sections::Contour& contour = read.value();
    all.insert(all.end(), contour.points.begin(), contour.points.end());
    sizes.push_back(contour.points.size());
    pieces.push_back({std::move(contour), false, 0});
  }
  if (sizes.size() > 1 && !geometry::areSimple(all, sizes)) {
    return Failure{Error::StackInvalid, "curves on " + nameOf(standing) + " cross each other: move them apart"};
  }
  sections::nest(pieces);
  return pieces;
}

/// Middle of the curves of a sheet, by their areas.
ModelPoint middleOf(const Sheet& sheet) {
  SectionPoint sum;
  double total = 0;
  for (const sections::SectionPiece& piece : sheet.pieces) {
    if (piece.hole) continue;
    const std::span<const SectionPoint> points(piece.contour.points);
    const double area = geometry::signedArea(points);
    sum += geometry::centroid(points) * area;
    total += area;
  }
  return sheet.stand.at(sum / total);
}

/// The same place in space seen from behind.
void turnOver(Sheet& sheet) {
  sheet.stand.y = -sheet.stand.y;
  for (sections::SectionPiece& piece : sheet.pieces) {
    for (SectionPoint& p : piece.contour.points) p.y = -p.y;
    reverse(piece.contour);
  }
}

/// Turns sheets over whose normal points against the way through the stack.
void faceTravel(Sheets& sheets) {
  const std::size_t n = sheets.all.size();
  std::vector<ModelPoint> middles;
  for (const Sheet& sheet : sheets.all) middles.push_back(middleOf(sheet));
  for (std::size_t i = 0; i < n; ++i) {
    Sheet& sheet = sheets.all[i];
    ModelPoint travel;
    if (sheets.alongRail) {
      travel = sheets.rail->at(sheet.at).tangent;
    } else {
      if (i > 0) travel += normalized(middles[i] - middles[i - 1]);
      if (i + 1 < n) travel += normalized(middles[i + 1] - middles[i]);
    }
    if (dot(sheet.stand.normal(), travel) < 0) turnOver(sheet);
  }
}

/// How far the curves of one sheet are ahead of the plane of another at least; behind it with `way` −1.
double leastAhead(const Sheet& of, const Sheet& curves, double way) {
  double least = INFINITY;
  for (const sections::SectionPiece& piece : curves.pieces) {
    for (const SectionPoint p : piece.contour.points) {
      least = std::min(least, way * dot(curves.stand.at(p) - of.stand.origin, of.stand.normal()));
    }
  }
  return least;
}

/// Sheets that cut each other within their curves, or stand in the wrong order.
Status checkOrder(const Sheets& sheets) {
  constexpr double kStep = 1e-4;  // of the rail
  for (std::size_t i = 1; i < sheets.all.size(); ++i) {
    const Sheet &a = sheets.all[i - 1], &b = sheets.all[i];
    const std::string both = nameOf(a.plane) + " and " + nameOf(b.plane);
    if (sheets.alongRail) {
      if (!(b.at - a.at >= kStep)) {
        return {Error::StackInvalid, both + " stand at one place of the rail or in the wrong order: move one along it"};
      }
      continue;
    }
    if (!(leastAhead(a, b, 1) > 0) || !(leastAhead(b, a, -1) > 0)) {
      return {Error::StackInvalid,
              both + " stand at one place or cut each other inside their curves: move or turn one"};
    }
  }
  if (sheets.closed() && sheets.all.size() > 1 && !(sheets.all.front().at + 1 - sheets.all.back().at >= kStep)) {
    return {Error::StackInvalid, "the first and the last sheet stand at one place of the ring: move one along it"};
  }
  return Done{};
}

/// Gives each sheet the links of its plane, where the plane that they are about follows: copies of a pattern are
/// followed by others. Errors: StackInvalid.
Status takeLinks(const std::vector<Plane>& planes, Sheets& sheets) {
  const std::size_t n = sheets.all.size();
  for (std::size_t i = 0; i < n; ++i) {
    Sheet& sheet = sheets.all[i];
    const Plane& plane = planes[sheet.plane.number];
    const Sheet& next = sheets.all[(i + 1) % n];
    if (i + 1 == n && !sheets.closed()) break;
    if (next.plane.number != nextDrawn(planes, sheets.closed(), sheet.plane.number)) continue;
    for (const CurveLink& link : plane.links) {
      if (sheet.pieces[link.from].hole == next.pieces[link.to].hole) continue;
      return {Error::StackInvalid, "curve " + std::to_string(link.from + 1) + " on " + nameOf(sheet.plane) +
                                       " is linked with curve " + std::to_string(link.to + 1) + " on " +
                                       nameOf(next.plane) + ", and only one of them is a hole: link holes with holes"};
    }
    sheet.links = plane.links;
  }
  return Done{};
}

}  // namespace

Result<Sheets> standSheets(const std::vector<Plane>& planes, const Rail& rail, const std::vector<Pattern>& patterns) {
  Sheets sheets;
  if (!rail.points.empty()) {
    Result<RailLine> line = RailLine::of(rail);
    if (!line) return line.failure();
    sheets.rail = std::move(line).value();
  }
  sheets.alongRail = sheets.rail.has_value();
  std::vector<std::vector<sections::SectionPiece>> read(planes.size());  // by plane: copies have the same
  for (const Standing& standing : writtenOut(planes, patterns)) {
    Plane plane = planes[standing.number];
    plane.at = standing.at;
    if (plane.curves.empty()) continue;
    if (!plane.origin && !sheets.rail) {
      return Failure{Error::StackInvalid, nameOf(standing) + " has no origin, and there is no rail that it stands on"};
    }
    if (plane.origin) sheets.alongRail = false;
    if (read[standing.number].empty()) {
      Result<std::vector<sections::SectionPiece>> pieces = readCurves(plane, standing);
      if (!pieces) return pieces.failure();
      read[standing.number] = std::move(pieces).value();
    }
    std::vector<Trait> traits;
    for (const Curve& curve : plane.curves) {
      traits.push_back({curve.as == CurveUse::Ground, curve.forkAt, curve.joinAt});
    }
    sheets.all.push_back({standing,
                          standOf(plane, sheets.rail),
                          plane.at,
                          read[standing.number],
                          std::move(traits),
                          std::move(plane.blend),
                          {}});
  }
  if (sheets.all.size() == 1 && !sheets.rail) {
    return Failure{Error::StackInvalid, "one sheet alone has no height: draw on another sheet"};
  }
  if (sheets.all.size() == 1 && sheets.alongRail && !sheets.rail->closed()) {  // the same from end to end
    Plane ends = planes[sheets.all.front().plane.number];
    for (const double at : {0.0, 1.0}) {
      ends.at = at;
      Sheet sheet = sheets.all.front();
      sheet.at = at;
      sheet.stand = standOf(ends, sheets.rail);
      sheets.all.push_back(std::move(sheet));
    }
    sheets.all.erase(sheets.all.begin());
  }
  if (sheets.all.size() == 1 && !sheets.closed()) {
    return Failure{Error::StackInvalid, "one sheet beside the rail has no height: put it on the rail"};
  }
  if (Status linked = takeLinks(planes, sheets); !linked) return linked.failure();
  faceTravel(sheets);
  if (Status order = checkOrder(sheets); !order) return order.failure();
  return sheets;
}

}  // namespace spineloft::stack
