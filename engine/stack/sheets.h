// Planes of a stack as they stand in space, with the curves on them fit for work. Internal to stack/.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/base/result.h"
#include "engine/sections/contour.h"
#include "engine/stack/rail_line.h"
#include "engine/stack/repeat.h"
#include "engine/stack/stack_params.h"
#include "engine/stack/stand.h"

namespace spineloft::stack {

/// What a curve is besides its outline.
struct Trait {
  bool ground = false;                   ///< it has a side that stays below (CurveUse::Ground)
  std::optional<double> forkAt, joinAt;  ///< as Curve's
};

/// One plane with curves. Its normal points along the way through the stack.
struct Sheet {
  Standing plane;
  Stand stand;
  double at = 0;                               ///< share of the rail
  std::vector<sections::SectionPiece> pieces;  ///< plane coordinates, counter-clockwise, holes too
  std::vector<Trait> traits;                   ///< by piece
  sections::Blend blend;
  std::vector<CurveLink> links;  ///< to the next sheet
};

/// What stands where. Sheets without curves are left out.
struct Sheets {
  std::vector<Sheet> all;
  std::optional<RailLine> rail;
  /// Every plane stands on the rail, and what is between two planes goes along it.
  bool alongRail = false;
  bool closed() const { return alongRail && rail->closed(); }
};

/// Where a plane stands. Planes on the rail need one.
Stand standOf(const Plane& plane, const std::optional<RailLine>& rail);

/// The planes with patterns written out, which are valid (checkPatterns). Errors: StackInvalid, which names sheet and
/// curve.
Result<Sheets> standSheets(const std::vector<Plane>& planes, const Rail& rail, const std::vector<Pattern>& patterns);

}  // namespace spineloft::stack
