#include "engine/lathe/half_plane.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/base/limits.h"
#include "engine/geometry/axis_clip.h"
#include "engine/geometry/polygon.h"
#include "engine/geometry/polyline.h"
#include "engine/geometry/region_grid.h"

namespace spineloft::lathe {
namespace {

using Line = std::vector<SectionPoint>;
using Lines = std::vector<Line>;
using geometry::Contours, geometry::onAxis, geometry::PictureFrame;

/// Shares of the profile's size: ends this near the axis lie on it, and so does any corner this near.
constexpr double kEndReach = 0.02, kOnAxis = 1e-4;
/// How far outlines read off a grid, and those with too many corners, may be simplified.
constexpr double kGridTolerance = 2e-4, kMostTolerance = 1e-3;

struct Bounds {
  SectionPoint low, high;
  double size() const { return distance(low, high); }
};
Bounds boundsOf(const Lines& lines) {
  Bounds bounds{lines.front().front(), lines.front().front()};
  for (const Line& line : lines) {
    for (const SectionPoint p : line) {
      bounds.low = {std::min(bounds.low.x, p.x), std::min(bounds.low.y, p.y)};
      bounds.high = {std::max(bounds.high.x, p.x), std::max(bounds.high.y, p.y)};
    }
  }
  return bounds;
}

/// The pieces of an open line at r ≥ 0.
void addPieces(const Line& line, Lines& out) {
  Line piece;
  const auto finish = [&] {
    if (piece.size() > 1) out.push_back(std::move(piece));
    piece.clear();
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    const SectionPoint p = line[i];
    const bool crosses = i > 0 && line[i - 1].x * p.x < 0;
    if (crosses) piece.push_back(onAxis(line[i - 1], p));
    if (p.x >= 0) piece.push_back(p);
    if (p.x <= 0) finish();
    if (p.x == 0) piece.push_back(p);
  }
  finish();
}

/// An open line with the straight ways from its ends to the axis.
Line closedAtAxis(const Line& line) {
  Line out;
  if (line.front().x != 0) out.push_back({0, line.front().y});
  out.insert(out.end(), line.begin(), line.end());
  if (line.back().x != 0) out.push_back({0, line.back().y});
  return out;
}

/// ∫ r over what closed lines enclose at r ≥ 0, whichever way round they go: the volume of the solid over 2π.
double volumeBeside(const Lines& closed) {
  double volume = 0;
  for (const Line& line : closed) {
    Line kept;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const SectionPoint p = line[i], q = line[(i + 1) % line.size()];
      if (p.x >= 0) kept.push_back(p);
      if (p.x * q.x < 0) kept.push_back(onAxis(p, q));
    }
    double own = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const SectionPoint p = kept[i], q = kept[(i + 1) % kept.size()];
      own += (p.x + q.x) * cross(p, q) / 6;
    }
    volume += std::abs(own);
  }
  return volume;
}

void mirror(Lines& lines) {
  for (Line& line : lines) {
    for (SectionPoint& p : line) p.x = -p.x;
  }
}

/// Picture coordinates whose frame holds bounds and margin, so that nothing is cut off there.
struct Framed {
  SectionPoint low, high;
  PictureFrame frame;
  Framed(const Bounds& bounds, double margin)
      : low(bounds.low - SectionPoint{margin, margin}),
        high(bounds.high + SectionPoint{margin, margin}),
        frame{high.x - low.x + 1, high.y - low.y + 1} {}
  PicturePoint to(SectionPoint p) const { return {p.x - low.x, high.y - p.y}; }
  SectionPoint from(PicturePoint p) const { return {p.x + low.x, high.y - p.y}; }
  Contours to(const Lines& lines) const {
    Contours out;
    for (const Line& line : lines) {
      auto& contour = out.emplace_back();
      for (const SectionPoint p : line) contour.push_back(to(p));
    }
    return out;
  }
  Lines from(const Contours& contours) const {
    Lines out;
    for (const auto& contour : contours) {
      Line& line = out.emplace_back();
      for (const PicturePoint p : contour) line.push_back(from(p));
    }
    return out;
  }
};

bool areSimple(const Lines& outlines) {
  Line points;
  std::vector<std::size_t> sizes;
  for (const Line& line : outlines) {
    points.insert(points.end(), line.begin(), line.end());
    sizes.push_back(line.size());
  }
  return geometry::areSimple(points, sizes);
}

/// With fewer corners, where that leaves them simple.
Lines thinned(const Lines& outlines, double tolerance) {
  Lines out;
  for (const Line& line : outlines) out.push_back(geometry::simplified(line, tolerance));
  return areSimple(out) ? out : outlines;
}

std::size_t countCorners(const Lines& outlines) {
  std::size_t corners = 0;
  for (const Line& line : outlines) corners += line.size();
  return corners;
}

/// The wall inside of open lines at r ≥ 0, which their mirror images continue beyond the axis.
Result<Lines> wallOf(const Lines& pieces, double thickness) {
  Lines outlines, lines = pieces, mirrored = pieces;
  mirror(mirrored);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Line& outline = outlines.emplace_back(pieces[i]);
    outline.insert(outline.end(), mirrored[i].rbegin(), mirrored[i].rend());
    lines.push_back(mirrored[i]);
  }
  const Framed framed(boundsOf(outlines), 1);
  std::vector<geometry::Wall::End> ends;
  const auto end = [&](SectionPoint at, SectionPoint before) {
    const PicturePoint p = framed.to(at);
    if (at.x != 0) ends.push_back({p, normalized(p - framed.to(before))});
  };
  for (const Line& line : lines) {
    end(line.front(), line[1]);
    end(line.back(), line[line.size() - 2]);
  }
  const Contours all = framed.to(outlines), drawn = framed.to(lines);
  const Contours wall = geometry::wallOutlines({all, drawn, thickness, ends}, framed.frame);
  if (wall.empty()) return Error::WallTooThick;
  const Result<Contours> clean = geometry::cleanRegion(wall, 0, framed.frame);
  if (!clean) return clean.failure();
  return thinned(framed.from(clean.value()), kGridTolerance * boundsOf(pieces).size());
}

/// What closed outlines enclose, or what the pen of an open line leaves.
Result<Lines> cleaned(const Lines& lines, double ribbon) {
  const Framed framed(boundsOf(lines), 1 + ribbon);
  const Result<Contours> clean = geometry::cleanRegion(framed.to(lines), ribbon, framed.frame);
  if (!clean) return clean.failure();
  Lines outlines = framed.from(clean.value());
  const bool asDrawn = countCorners(outlines) <= countCorners(lines);
  return asDrawn ? outlines : thinned(outlines, kGridTolerance * boundsOf(lines).size());
}

Axis axisOf(const LatheParams& params) {
  const PicturePoint along = normalized(params.axisTo - params.axisFrom);
  return {params.axisFrom, along, {-along.y, along.x}};
}

/// The lines with r and h, without repeated points; too short ones are left out.
Lines inHalfPlane(const Profile& profile, const Axis& axis) {
  const std::size_t least = profile.open || profile.ribbon > 0 ? 2 : 3;
  Lines out;
  for (const auto& contour : profile.lines) {
    Line line;
    for (const PicturePoint p : contour) line.push_back(axis.inHalfPlane(p));
    geometry::dropRepeats(line, kSamePoint);
    if (line.size() >= least) out.push_back(std::move(line));
  }
  return out;
}

void snapToAxis(Lines& lines, double reach) {
  for (Line& line : lines) {
    for (SectionPoint& p : line) {
      if (std::abs(p.x) < reach) p.x = 0;
    }
  }
}

/// Whether lines mean the side of negative r, which is the one that makes the larger solid.
bool isBeyond(Lines lines, bool open) {
  if (open) std::ranges::transform(lines, lines.begin(), closedAtAxis);
  const double right = volumeBeside(lines);
  mirror(lines);
  return volumeBeside(lines) > right;
}

/// What open lines and the axis enclose, or the wall along them.
Result<Lines> closedPieces(const Lines& lines, double wall) {
  Lines pieces, closed;
  for (const Line& line : lines) addPieces(line, pieces);
  for (const Line& piece : pieces) {
    closed.push_back(closedAtAxis(piece));
    if (closed.back().size() < 3) closed.pop_back();
  }
  if (closed.empty()) return Error::ProfileOnAxis;
  return wall > 0 ? wallOf(pieces, wall) : cleaned(closed, 0);
}

}  // namespace

Result<HalfPlaneRegion> halfPlaneRegion(const Profile& profile, const LatheParams& params, double wall) {
  HalfPlaneRegion region{axisOf(params), {}};
  Lines lines = inHalfPlane(profile, region.axis);
  if (lines.empty()) return Error::RegionEmpty;
  const double size = boundsOf(lines).size();
  const bool lineWise = profile.open || profile.ribbon > 0, open = profile.open && !(profile.ribbon > 0);
  if (open) {
    for (Line& line : lines) {
      for (SectionPoint* end : {&line.front(), &line.back()}) {
        if (std::abs(end->x) < kEndReach * size) end->x = 0;
      }
    }
  }
  snapToAxis(lines, kOnAxis * size);
  if (isBeyond(lines, lineWise)) {
    region.axis.aside = -region.axis.aside;
    mirror(lines);
  }
  Result<Lines> clean = open ? closedPieces(lines, wall) : cleaned(lines, profile.ribbon);
  if (!clean) return clean.failure();
  region.outlines = std::move(clean).value();
  for (double tolerance = kMostTolerance / 8; countCorners(region.outlines) > kMostCorners; tolerance *= 2) {
    if (tolerance > kMostTolerance) return Error::RegionTooFine;
    region.outlines = thinned(region.outlines, tolerance * size);
  }
  snapToAxis(region.outlines, kOnAxis * size);
  region.outlines = geometry::clippedAtAxis(region.outlines);
  if (region.outlines.empty()) return Error::ProfileOnAxis;
  return region;
}

}  // namespace spineloft::lathe
