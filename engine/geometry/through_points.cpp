#include "engine/geometry/through_points.h"

#include "engine/geometry/hermite.h"

namespace spineloft::geometry {
namespace {

/// Slope at `b` of a smooth curve through a, b, c whose parameter is the distance along it.
PicturePoint slopeAt(PicturePoint a, PicturePoint b, PicturePoint c) {
  const double before = distance(a, b), after = distance(b, c);
  if (!(before > 0) || !(after > 0)) return {};
  return parabolaSlope(a, b, c, before, after);
}

}  // namespace

void throughPoints(std::span<const PicturePoint> points, std::size_t steps, std::vector<PicturePoint>& out) {
  out.clear();
  out.reserve((points.size() - 3) * steps + 1);
  for (std::size_t i = 1; i + 2 < points.size(); ++i) {
    const PicturePoint a = points[i], b = points[i + 1];
    const double span = distance(a, b);
    const PicturePoint ma = slopeAt(points[i - 1], a, b) * span;
    const PicturePoint mb = slopeAt(a, b, points[i + 2]) * span;
    for (std::size_t k = 0; k < steps; ++k) {
      out.push_back(hermite(a, b, ma, mb, static_cast<double>(k) / static_cast<double>(steps)));
    }
  }
  out.push_back(points[points.size() - 2]);
}

}  // namespace spineloft::geometry
