#include "engine/inflate/inflate.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "engine/geometry/pieces.h"
#include "engine/geometry/refine.h"
#include "engine/inflate/bone_edits.h"
#include "engine/inflate/cushion.h"
#include "engine/inflate/fields.h"
#include "engine/inflate/poisson_height.h"
#include "engine/inflate/profile.h"
#include "engine/inflate/rows.h"
#include "engine/mesh/two_sided.h"

namespace spineloft::inflate {
namespace {

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
/// about the area of the region times their length.
double spacingFor(double area, int points, std::span<const ProfileCurve> curves) {
  double length = 0;
  for (const ProfileCurve& curve : curves) {
    const std::size_t n = curve.points.size();
    for (std::size_t i = curve.closed ? 0 : 1; i < n; ++i) {
      length += distance(curve.points[i], curve.points[(i + n - 1) % n]);
    }
  }
  return std::sqrt(length * area / (std::sqrt(0.75) * points));
}

Result<mesh::TriMesh> inflateAlong(const geometry::Contours& contours, image::Size picture,
                                   const InflateParams& params) {
  const Result<std::vector<ProfileCurve>> curves = profileCurves(params.profile.slices[0].shape, params.sides);
  if (!curves) return curves.failure();
  const std::vector<geometry::Contours> pieces = geometry::piecesOf(contours);
  std::vector<Fields> fields;
  RowParams rows{spacingFor(geometry::areaOf(contours), params.points, curves.value()), params.height,
                 params.profile.follow, 0, picture};
  for (const geometry::Contours& piece : pieces) {
    const Result<EditedSkeleton> bones = editedSkeleton(piece, params.bones);
    if (!bones) return bones.failure();
    Result<Fields> made = fieldsOf(piece, bones.value().skeleton);
    if (!made) return made.failure();
    rows.widest = std::max(rows.widest, std::ranges::max(made.value().half));
    fields.push_back(std::move(made).value());
  }
  mesh::TriMesh mesh;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (Status status = addRows(fields[i], pieces[i], curves.value(), rows, mesh); !status) {
      return status.failure();
    }
  }
  return mesh;
}

}  // namespace

Result<mesh::TriMesh> inflateRegion(const geometry::Contours& contours, image::Size picture,
                                    const InflateParams& params) {
  if (!isValid(params)) return Error::ValueOutOfRange;
  if (!(geometry::areaOf(contours) > 0)) return Error::RegionEmpty;
  return params.profile.isSoft() ? inflateSoftly(contours, picture, params) : inflateAlong(contours, picture, params);
}

}  // namespace spineloft::inflate
