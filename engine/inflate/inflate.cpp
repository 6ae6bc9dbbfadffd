#include "engine/inflate/inflate.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "engine/geometry/refine.h"
#include "engine/inflate/cushion.h"
#include "engine/inflate/interior.h"
#include "engine/inflate/poisson_height.h"
#include "engine/inflate/profile.h"
#include "engine/inflate/rows.h"
#include "engine/inflate/thin_rings.h"
#include "engine/mesh/self_crossing.h"
#include "engine/mesh/thin_triangles.h"
#include "engine/mesh/two_sided.h"

namespace spineloft::inflate {
namespace {

/// Of the spacing: how far a point may come to lie off the surface where thin triangles go.
constexpr double kMostOff = 0.1;
/// Heights below this share of the spacing would make both sides touch.
constexpr double kLeastHeightShare = 1e-3;

std::vector<double> heightsOf(const std::vector<double>& u, std::size_t rim, double height, double least) {
  std::vector<double> heights(u.size(), 0.0);
  for (std::size_t i = rim; i < u.size(); ++i) {
    heights[i] = std::max(least, height * std::sqrt(std::max(0.0, u[i])));
  }
  return heights;
}

using Point = Vec3<ModelSpace>;

/// Flips edges where the angles opposite them, measured on the surface, are too wide.
void flipOnSurface(geometry::PlaneMesh& mesh, const std::vector<double>& heights) {
  const auto at = [&](std::uint32_t p) { return Point{mesh.points()[p].x, mesh.points()[p].y, heights[p]}; };
  struct Angle {
    double sine, cosine;  ///< both times the lengths of the legs
  };
  const auto angle = [](Point a, Point tip, Point b) {
    const Point v = a - tip, w = b - tip;
    return Angle{norm(cross(v, w)), dot(v, w)};
  };
  const std::uint32_t rim = static_cast<std::uint32_t>(mesh.rim());
  mesh.flipWhere(
      [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        if (c < rim && d < rim) return false;  // would be a chord, where both sides meet
        const Point pa = at(a), pb = at(b), pc = at(c), pd = at(d);
        constexpr double kClearly = 1e-3;  // radians more than half a turn
        const Angle one = angle(pa, pc, pb), other = angle(pa, pd, pb);
        const double legs = (one.sine + std::abs(one.cosine)) * (other.sine + std::abs(other.cosine));
        return one.sine * other.cosine + one.cosine * other.sine < -kClearly * legs;
      },
      4);
}

/// How far towards `to` a point may go: all of the way, a half, a quarter, or none, so that no triangle
/// round it shrinks to less than kLeastShare of its area in the plane. Points next to the rim, where the
/// surface is steep, would otherwise be drawn onto it.
SectionPoint within(const geometry::PlaneMesh& mesh, std::uint32_t p, SectionPoint to,
                    std::span<const std::uint32_t> fan) {
  constexpr double kLeastShare = 0.4;
  const auto& points = mesh.points();
  for (const double share : {1.0, 0.5, 0.25}) {
    const SectionPoint there = lerp(points[p], to, share);
    const bool roomy = std::ranges::all_of(fan, [&](std::uint32_t t) {
      const auto at = [&](std::uint32_t corner) { return corner == p ? there : points[corner]; };
      const auto& [a, b, c] = mesh.triangles()[t];
      const double was = cross(points[b] - points[a], points[c] - points[a]);
      return cross(at(b) - at(a), at(c) - at(a)) >= kLeastShare * was;
    });
    if (roomy) return there;
  }
  return points[p];
}

/// Once moves inner points towards the middle of what is round them on the surface, and looks up how high
/// the surface is there.
void relax(Cushion& cushion, double height, double least) {
  geometry::PlaneMesh& mesh = cushion.mesh;
  const std::vector<double> heights = heightsOf(cushion.u, mesh.rim(), height, least);
  flipOnSurface(mesh, heights);
  const geometry::PlaneMesh::Fans fans = mesh.fans();
  for (std::uint32_t p = static_cast<std::uint32_t>(mesh.rim()); p < mesh.points().size(); ++p) {
    SectionPoint sum{};
    double weights = 0;
    for (const std::uint32_t t : fans.at(p)) {
      const auto& [a, b, c] = mesh.triangles()[t];
      const auto& points = mesh.points();
      const Point pa{points[a].x, points[a].y, heights[a]};
      const Point pb{points[b].x, points[b].y, heights[b]};
      const Point pc{points[c].x, points[c].y, heights[c]};
      const double area = norm(cross(pb - pa, pc - pa));
      sum += (points[a] + points[b] + points[c]) * (area / 3);
      weights += area;
    }
    if (weights > 0) mesh.move(p, within(mesh, p, sum / weights, fans.at(p)), fans.at(p));
  }
  cushion.u = poissonHeight(mesh);
  if (cushion.u.empty()) return;
  flipOnSurface(mesh, heightsOf(cushion.u, mesh.rim(), height, least));
}

Result<mesh::TriMesh> inflateSoftly(const geometry::Contours& contours, image::Size picture,
                                    const InflateParams& params) {
  const double area = geometry::areaOf(contours);
  const double spacing = cushionSpacing(area, params.points);
  const geometry::PlaneRegion region = geometry::planeRegion(geometry::sampleRegion(contours, spacing));
  const Cushion coarse = evenCushion(region, kCoarse * spacing);
  if (coarse.u.empty()) return Error::RegionTooFine;
  Cushion fine = fineCushion(region, coarse, params.height, spacing);
  if (fine.u.empty()) return Error::RegionTooFine;
  const double least = kLeastHeightShare * spacing;
  relax(fine, params.height, least);
  if (fine.u.empty()) return Error::RegionTooFine;
  const std::vector<double> up = heightsOf(fine.u, region.points.size(), params.height, least);
  const mesh::PictureSize size{static_cast<double>(picture.width), static_cast<double>(picture.height)};
  const std::vector<double> flat(coarse.u.size(), 0.0);
  std::vector<double> down(up.size());
  std::ranges::transform(up, down.begin(), [](double h) { return -h; });
  const mesh::Side front{fine.mesh, up}, back{fine.mesh, down}, plane{coarse.mesh, flat};
  switch (params.sides) {
    case InflateSides::Front:
      return solidBetween(front, plane, region.sizes, size);
    case InflateSides::Back:
      return solidBetween(plane, back, region.sizes, size);
    case InflateSides::Both:
    case InflateSides::kCount:
      break;
  }
  return solidBetween(front, back, region.sizes, size);
}

/// How far points are apart when the curves of a profile, lengths in half widths, stand over a region: the surface has
/// about the area of the region times their length. Of several slices it is that of the longest.
double spacingFor(double area, int points, const MatchedCurves& curves) {
  double length = 0;
  for (const std::vector<ProfileCurve>& curve : curves) {
    double longest = 0;
    for (const auto& [line, closed] : curve) {
      const std::size_t n = line.size();
      double own = 0;
      for (std::size_t i = closed ? 0 : 1; i < n; ++i) own += distance(line[i], line[(i + n - 1) % n]);
      longest = std::max(longest, own);
    }
    length += longest;
  }
  return std::sqrt(length * area / (std::sqrt(0.75) * points));
}

/// Without thin triangles, as far as that moves no point farther `off` the surface, nor, of one that is not `plain`, a
/// stretch of it through another one.
mesh::TriMesh tidied(mesh::TriMesh mesh, double off, bool plain) {
  constexpr double kLess = 0.125;
  for (const double share : {1.0, kLess}) {
    mesh::TriMesh tidy = mesh;
    mesh::ThinLimits limits;
    limits.off = share * off;
    mesh::removeThinTriangles(tidy, limits);
    if (plain || !mesh::selfCrossing(tidy)) return tidy;
  }
  return mesh;
}

}  // namespace

Result<mesh::TriMesh> inflateAlong(const Interior& interior, image::Size picture, const InflateParams& params) {
  if (!isValid(params) || params.profile.isSoft()) return Error::ValueOutOfRange;
  Result<MatchedCurves> curves = matchedCurves(params.profile.slices, params.sides);
  if (!curves) return curves.failure();
  thickenRings(curves.value(), interior.bones, picture, params);
  const bool rim = params.profile.across == Across::Length;
  const double reach = rim ? params.profile.reach * std::max(picture.width, picture.height) : 0;
  RowParams rows{1, finenessFor(params.points), params.height, params.profile.follow, 0, picture};
  double area = 0;
  for (std::size_t i = 0; i < interior.pieces.size(); ++i) {
    area += geometry::areaOf(interior.pieces[i]);
    rows.widest = std::max(rows.widest, std::ranges::max(interior.fields[i].half));
  }
  if (rim) rows.widest = std::min(rows.widest, reach);
  rows.spacing = spacingFor(area, params.points, curves.value());
  mesh::TriMesh mesh;
  for (std::size_t i = 0; i < interior.pieces.size(); ++i) {
    const geometry::Contours& piece = interior.pieces[i];
    const Status status = rim ? addRows(withReach(interior.fields[i], reach), piece, curves.value(), rows, mesh)
                              : addRows(interior.fields[i], piece, curves.value(), rows, mesh);
    if (!status) return status.failure();
  }
  return tidied(std::move(mesh), kMostOff * (rim ? std::min(rows.spacing, reach) : rows.spacing),
                isPlain(curves.value()));
}

Result<mesh::TriMesh> inflateRegion(const geometry::Contours& contours, image::Size picture,
                                    const InflateParams& params) {
  if (!isValid(params)) return Error::ValueOutOfRange;
  if (!(geometry::areaOf(contours) > 0)) return Error::RegionEmpty;
  if (params.profile.isSoft()) return inflateSoftly(contours, picture, params);
  const Result<Interior> interior = interiorOf(contours, params.bones, params.profile.slices, params.points);
  if (!interior) return interior.failure();
  return inflateAlong(interior.value(), picture, params);
}

}  // namespace spineloft::inflate
