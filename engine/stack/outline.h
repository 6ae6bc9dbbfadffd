// Curves of a stack as the closed polygons that they enclose. Internal to stack/.
#pragma once

#include <string>
#include <vector>

#include "engine/sections/contour.h"
#include "engine/stack/stack_params.h"

namespace spineloft::stack {

/// What a valid curve encloses; corners are knots, of open curves also where the outline leaves them. Ribbons have
/// mitred corners, up to kMostMitre half widths long, else blunt ones; where they bend tighter than half their width
/// the polygon crosses itself.
sections::Contour polygonOf(const Curve& curve);
inline constexpr double kMostMitre = 4;

/// What a valid curve lacks to be closed, a ribbon or ground, and what to do, to follow its name: "has no width: …".
/// Empty: nothing.
std::string lackOf(const Curve& curve);

}  // namespace spineloft::stack
