#include "engine/inflate/cushion.h"

#include <algorithm>
#include <cmath>

#include "engine/geometry/spread.h"
#include "engine/inflate/poisson_height.h"

namespace spineloft::inflate {
namespace {

/// A ball has four times the area of its disc; most regions have less, which only makes them finer.
constexpr double kAreaOfBall = 4;
/// Rows follow the rim until the surface leans by so much, radians.
constexpr double kSteep = 0.95;
constexpr std::size_t kMostRows = 64;

/// Distances at which h = height · √(ρ² − (ρ − d)²) has gone on by one spacing along its arc, and so on.
std::vector<double> rowsFor(double radius, double height, double spacing) {
  std::vector<double> rows;
  const double round = radius * height * height;
  if (!(round > 0)) return rows;
  const double step = spacing / round;
  for (std::size_t k = 1; k <= kMostRows && static_cast<double>(k) * step < kSteep; ++k) {
    const double away = round * (1 - std::cos(static_cast<double>(k) * step));
    if (away > 0.8 * radius) break;
    rows.push_back(away);
  }
  return rows;
}

}  // namespace

double cushionSpacing(double area, int points) { return std::sqrt(kAreaOfBall * area / (std::sqrt(0.75) * points)); }

Cushion evenCushion(const geometry::PlaneRegion& region, double spacing) {
  Cushion cushion{geometry::PlaneMesh(region.points, region.sizes), {}};
  if (cushion.mesh.empty()) return cushion;
  geometry::spreadPoints(cushion.mesh, region.sizes, {spacing, spacing},
                         {[](std::size_t) { return std::vector<double>{}; }, [](SectionPoint) { return 0.0; }});
  cushion.u = poissonHeight(cushion.mesh);
  return cushion;
}

Cushion fineCushion(const geometry::PlaneRegion& region, const Cushion& coarse, double height, double spacing) {
  Cushion cushion{geometry::PlaneMesh(region.points, region.sizes), {}};
  const std::vector<double> radii = rimRadii(coarse.mesh, coarse.u);
  const geometry::SurfaceOver surface{
      [&](std::size_t corner) { return rowsFor(radii[corner], height, spacing); },
      [&](SectionPoint p) { return height * std::sqrt(std::max(0.0, valueAt(coarse.mesh, coarse.u, p))); }};
  geometry::spreadPoints(cushion.mesh, region.sizes, {spacing, spacing}, surface);
  cushion.u = poissonHeight(cushion.mesh);
  return cushion;
}

}  // namespace spineloft::inflate
