// Where the planes of a stack stand in space, and the curves on them as polygons.
#pragma once

#include <vector>

#include "engine/base/result.h"
#include "engine/base/vec.h"
#include "engine/stack/stack_params.h"

namespace spineloft::stack {

/// A place in space with two unit directions in a plane, square to each other.
struct Stand {
  ModelPoint origin, x, y;
  ModelPoint normal() const { return cross(x, y); }
  ModelPoint at(SectionPoint p) const { return origin + x * p.x + y * p.y; }
  SectionPoint in(ModelPoint p) const { return {dot(p - origin, x), dot(p - origin, y)}; }
};

/// Where a plane stands. Error: StackInvalid (a plane on a rail that has no length).
Result<Stand> standOf(const Plane& plane, const Rail& rail);

/// What turns `from` so that its directions are those of `to`, in the coordinates of `from`: Plane::turn of a plane
/// that stands as `to` does, where `from` is how it stands without one.
geometry::Turn turnBetween(const Stand& from, const Stand& to);

/// The same for several planes, which have the rail's line made once.
Result<std::vector<Stand>> standsOf(const std::vector<Plane>& planes, const Rail& rail);

/// Length of the rail's line, picture pixels; 0 where it has none.
double lengthOf(const Rail& rail);

/// A closed curve through the points of a drawing, in its units.
Curve curveThrough(const sections::DrawnCurve& drawn);

/// What a valid curve encloses, as a ribbon or as ground if it is one, as a closed polygon within a ten-thousandth of
/// half the curve's size; the last point is not the first one again.
std::vector<SectionPoint> outlineOf(const Curve& curve);

}  // namespace spineloft::stack
