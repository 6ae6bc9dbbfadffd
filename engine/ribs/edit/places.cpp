#include "engine/ribs/edit/places.h"

#include <algorithm>
#include <cmath>

#include "engine/geometry/polyline.h"

namespace spineloft::ribs {
namespace {

// Half the stretch over which the tangent is taken, as a share of the length.
constexpr double kTangentReach = 0.03;

}  // namespace

Ruler::Ruler(std::span<const PicturePoint> points) : points_(points), lengths_(geometry::arcLengths(points)) {}

PicturePoint Ruler::pointAt(double at) const {
  return geometry::pointAt(points_, std::span<const double>(lengths_), std::clamp(at, 0.0, 1.0) * length());
}

PicturePoint Ruler::tangentAt(double at) const {
  // Narrower stretches where the wide one comes back to where it began (a hairpin).
  for (double reach = kTangentReach; reach > 1e-4; reach /= 4) {
    const PicturePoint chord = pointAt(at + reach) - pointAt(at - reach);
    if (norm(chord) > 1e-6 * length()) return normalized(chord);
  }
  return {1, 0};
}

PicturePoint Ruler::outAt(double at, Side side) const {
  const PicturePoint t = tangentAt(at);
  return side == Side::Left ? PicturePoint{t.y, -t.x} : PicturePoint{-t.y, t.x};
}

double Ruler::placeOf(PicturePoint p) const {
  double best = 0, nearest = distance(p, points_[0]);
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
    const PicturePoint along = points_[i + 1] - points_[i];
    const double squared = dot(along, along);
    const double t = squared > 0 ? std::clamp(dot(p - points_[i], along) / squared, 0.0, 1.0) : 0;
    const double away = distance(p, points_[i] + along * t);
    if (away < nearest) {
      nearest = away;
      best = lengths_[i] + t * (lengths_[i + 1] - lengths_[i]);
    }
  }
  return length() > 0 ? std::clamp(best / length(), 0.0, 1.0) : 0;
}

double Ruler::placeOfPoint(std::size_t i) const { return length() > 0 ? lengths_[i] / length() : 0; }

PicturePoint Ruler::fromFrame(const EndEdit& edit) const {
  return pointAt(edit.at) + tangentAt(edit.at) * edit.along + outAt(edit.at, edit.side) * edit.out;
}

void Ruler::toFrame(PicturePoint p, EndEdit& edit) const {
  const PicturePoint from = p - pointAt(edit.at);
  edit.along = dot(from, tangentAt(edit.at));
  edit.out = dot(from, outAt(edit.at, edit.side));
}

std::vector<double> ribPlaces(const Ruler& ruler, const Spine& spine, const RibSet& ribs) {
  std::vector<double> places(ribs.ribs.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const PicturePoint centre = ribs.ribs[i].center;
    const bool onPoint = i < spine.points.size() && spine.points[i] == centre;
    places[i] = onPoint ? ruler.placeOfPoint(i) : ruler.placeOf(centre);
  }
  return places;
}

double bell(double share) {
  const double u = std::clamp(std::abs(share), 0.0, 1.0);
  return 1 - u * u * (3 - 2 * u);
}

}  // namespace spineloft::ribs
