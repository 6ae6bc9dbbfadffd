#include "web/edit/graph_points.h"

#include <algorithm>

namespace spineloft::app {

bool isFixedPoint(GraphArea::Kind kind, const geometry::AlongCurve& curve, std::size_t point) {
  return kind == GraphArea::Kind::Blend && (point == 0 || point + 1 == curve.points.size());
}

std::pair<double, double> roomOfPoint(const geometry::AlongCurve& curve, std::size_t point) {
  const double low = point > 0 ? curve.points[point - 1].at + kLeastGraphGap : 0;
  const double high = point + 1 < curve.points.size() ? curve.points[point + 1].at - kLeastGraphGap : 1;
  return {low, high};
}

geometry::AlongCurve withPointAt(geometry::AlongCurve curve, geometry::AlongPoint added, double rest,
                                 std::size_t& point) {
  if (curve.empty()) curve.points = {{0, rest}, {1, rest}};
  auto next = std::ranges::lower_bound(curve.points, added.at - kLeastGraphGap, {}, &geometry::AlongPoint::at);
  const bool there = next != curve.points.end() && next->at <= added.at + kLeastGraphGap;
  if (!there) next = curve.points.insert(next, added);
  point = static_cast<std::size_t>(next - curve.points.begin());
  return curve;
}

double widestGap(const geometry::AlongCurve& curve) {
  double at = 0.5, widest = 0;
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
    const double gap = curve.points[i + 1].at - curve.points[i].at;
    if (gap <= widest) continue;
    widest = gap;
    at = curve.points[i].at + gap / 2;
  }
  return at;
}

}  // namespace spineloft::app
