// The rail through the centres of what is drawn on the planes of a stack.
#pragma once

#include <optional>
#include <vector>

#include "engine/base/result.h"
#include "engine/stack/stack_params.h"

namespace spineloft::stack {

/// Centre of area of what a plane's curves enclose, each by itself; none without curves.
std::optional<SectionPoint> centreOf(const Plane& plane);
/// Moves the curves in their plane.
void moveCurves(Plane& plane, SectionPoint by);

/// Planes on a rail of their own.
struct OnRail {
  std::vector<Plane> planes;
  Rail rail;
};

/// Puts planes with curves on the rail through the centres of area of what each of them has, in their order; closed if
/// `rail` is. Every plane keeps its place and direction in space (its `turn` is from the new rail), so that no curve
/// moves by more than a thousandth of a picture pixel; the ways between them follow the new rail
/// (cross-sections-hughes 3). `rail` is what they stand on until now; planes off it come onto the new one.
///
/// Errors: StackInvalid (fewer than two planes with curves, three on a closed rail; a plane without curves; two centres
/// in one place), and those of standOf.
Result<OnRail> ontoCentres(const std::vector<Plane>& planes, const Rail& rail);

}  // namespace spineloft::stack
