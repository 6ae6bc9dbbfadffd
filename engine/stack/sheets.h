// Planes of a stack as they stand in space, with the curves on them fit for work. Internal to stack/.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/base/result.h"
#include "engine/sections/contour.h"
#include "engine/stack/rail_line.h"
#include "engine/stack/stack_params.h"

namespace spineloft::stack {

/// A place in space with two unit directions in a plane, square to each other.
struct Stand {
  ModelPoint origin, x, y;
  ModelPoint normal() const { return cross(x, y); }
  ModelPoint at(SectionPoint p) const { return origin + x * p.x + y * p.y; }
  SectionPoint in(ModelPoint p) const { return {dot(p - origin, x), dot(p - origin, y)}; }
};

/// One plane with curves. Its normal points along the way through the stack.
struct Sheet {
  std::size_t number = 0;  ///< which of the planes
  Stand stand;
  double at = 0;                               ///< share of the rail
  std::vector<sections::SectionPiece> pieces;  ///< plane coordinates, counter-clockwise, holes too
  sections::Blend blend;
};

/// What stands where. Sheets without curves are left out.
struct Sheets {
  std::vector<Sheet> all;
  std::optional<RailLine> rail;
  /// Every plane stands on the rail, and what is between two planes goes along it.
  bool alongRail = false;
  bool closed() const { return alongRail && rail->closed(); }
};

/// Errors: StackInvalid, which names sheet and curve.
Result<Sheets> standSheets(const std::vector<Plane>& planes, const Rail& rail);

}  // namespace spineloft::stack
