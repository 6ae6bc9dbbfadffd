// A profile in the half plane of its axis: x is the distance r from the axis, y the way h along it. Internal to lathe/.
#pragma once

#include <vector>

#include "engine/lathe/lathe.h"

namespace spineloft::lathe {

/// The axis in the picture, and the side of it on which r is positive.
struct Axis {
  PicturePoint from, along, aside;  ///< picture pixels; unit vectors, square to one another

  SectionPoint inHalfPlane(PicturePoint p) const { return {dot(p - from, aside), dot(p - from, along)}; }
  PicturePoint inPicture(SectionPoint p) const { return from + aside * p.x + along * p.y; }
};

/// Polygons with r ≥ 0 that touch each other on the axis at most, corners on the axis exactly there; outer ones
/// counter-clockwise, holes clockwise.
struct HalfPlaneRegion {
  Axis axis;
  std::vector<std::vector<SectionPoint>> outlines;
};

/// What of the profile is turned (spinRegion). `wall` in picture pixels.
Result<HalfPlaneRegion> halfPlaneRegion(const Profile& profile, const LatheParams& params, double wall);

}  // namespace spineloft::lathe
