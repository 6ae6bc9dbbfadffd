#include "engine/extrude/extrude.h"

#include <algorithm>
#include <cmath>

#include "engine/geometry/refine.h"
#include "engine/geometry/ridge.h"
#include "engine/geometry/spread.h"
#include "engine/geometry/steady.h"
#include "engine/mesh/two_sided.h"

namespace spineloft::extrude {
namespace {

constexpr double kHalfPi = 1.57079632679489662;
/// Steps of a rounding from the wall to the face.
constexpr int kRoundSteps = 5;
/// An edge smaller than this share of half the thickness is sharp.
constexpr double kLeastEdge = 0.02;
/// The outline has a point about every so much of the square root of the area, and the faces one a
/// lattice cell.
constexpr double kOutlineShare = 0.02, kFaceShare = 0.08;
/// But not coarser along the outline than this many times a step of its edge.
constexpr double kMostAspect = 5;

/// Half of the cut across the rim: how high the surface stands at a distance from it.
class Profile {
 public:
  Profile(const ExtrudeParams& params, double thickness)
      : half_(thickness / 2),
        edge_(params.edge == EdgeKind::Sharp || params.edgeSize < kLeastEdge ? 0 : params.edgeSize * thickness / 2),
        round_(params.edge == EdgeKind::Round) {}

  double half() const { return half_; }
  double edge() const { return edge_; }
  double rim() const { return half_ - edge_; }
  double heightAt(double away) const {
    if (away >= edge_) return half_;
    if (!round_) return half_ - edge_ + away;
    const double left = edge_ - away;
    return half_ - edge_ + std::sqrt(std::max(0.0, edge_ * edge_ - left * left));
  }
  /// Distances from the rim where the surface gets a row of points.
  std::vector<double> rows() const {
    std::vector<double> rows;
    if (!(edge_ > 0)) return rows;
    const int steps = round_ ? kRoundSteps : 1;
    for (int k = 1; k < steps; ++k) rows.push_back(edge_ * (1 - std::cos(kHalfPi * k / steps)));
    rows.push_back(edge_);
    // One more on the face: what its triangles have of the edge's shading ends there, evenly.
    rows.push_back(edge_ + step());
    return rows;
  }
  /// Between rows, on the surface.
  double step() const { return edge_ * (round_ ? kHalfPi / kRoundSteps : std::sqrt(2.0)); }

 private:
  double half_, edge_;
  bool round_;
};

}  // namespace

Result<mesh::TriMesh> extrudeRegion(const geometry::Contours& contours, image::Size picture,
                                    const ExtrudeParams& params) {
  if (!isValid(params)) return Error::ValueOutOfRange;
  const double area = geometry::areaOf(contours);
  if (!(area > 0)) return Error::RegionEmpty;
  const double side = std::max({1, picture.width, picture.height});
  const Profile profile(params, params.thickness * side);
  const double size = std::sqrt(area);
  double along = kOutlineShare * size;
  if (profile.step() > 0) {
    along = std::clamp(kMostAspect * profile.step(), 0.5 * along, along);
  }
  // What is finer than a rounding would show as dents in it.
  constexpr double kSteadyReach = 1.0, kSteadyMost = 0.12;  // of the edge
  const geometry::Contours steady =
      profile.edge() > 0 ? geometry::steadied(contours, {kSteadyReach * profile.edge(), kSteadyMost * profile.edge()})
                         : contours;
  const geometry::PlaneRegion region = geometry::planeRegion(geometry::sampleRegion(steady, along));
  geometry::PlaneMesh mesh(region.points, region.sizes);
  if (mesh.empty()) return Error::RegionTooFine;
  const std::vector<double> rows = profile.rows();
  const geometry::RimDistance distances(region.points, region.sizes);
  const auto heightAt = [&](SectionPoint p) { return profile.heightAt(distances.to(p)); };
  const double face = kFaceShare * size;
  const double step = profile.step() > 0 ? std::min(profile.step(), face) : face;
  geometry::SurfaceOver surface{[&](std::size_t) { return rows; }, heightAt};
  if (!rows.empty()) {
    surface.features = geometry::ridgePoints(region.points, region.sizes, distances, {profile.edge(), step, rows});
  }
  geometry::spreadPoints(mesh, region.sizes, {step, face}, surface);
  if (!rows.empty()) {
    constexpr double kGain = 0.03;  // of the edge: more than its steps are off
    geometry::flipToSurface(mesh, heightAt, profile.half(), kGain * profile.edge());
  }
  std::vector<double> up(mesh.points().size()), down(up.size());
  const double middle = params.depth * side;
  for (std::size_t i = 0; i < up.size(); ++i) {
    const double high = i < mesh.rim() ? profile.rim() : heightAt(mesh.points()[i]);
    up[i] = middle + high;
    down[i] = middle - high;
  }
  return mesh::solidBetween({mesh, up}, {mesh, down}, region.sizes,
                            {static_cast<double>(picture.width), static_cast<double>(picture.height)});
}

}  // namespace spineloft::extrude
