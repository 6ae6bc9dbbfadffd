// Freehand lines that end, as walls and the ground are drawn (cross-sections-hughes 5.1).
#pragma once

#include <span>

#include "engine/base/result.h"
#include "engine/sections/drawing.h"

namespace spineloft::sections {

/// A freehand line as a curve that ends at its last point (openStretchOf), in section units: tremor is smoothed,
/// corners stay, and the ends are where the line begins and ends. Both ends are marked as corners. Errors:
/// SectionInvalid (fewer than 3 distinct points), StrokeNotFinite.
Result<DrawnCurve> drawOpenLine(std::span<const SectionPoint> stroke);

}  // namespace spineloft::sections
