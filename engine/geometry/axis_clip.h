// Polygons cut at the axis x = 0.
#pragma once

#include <vector>

#include "engine/base/vec.h"

namespace spineloft::geometry {

/// What of simple polygons (outer ones and holes in opposite directions) lies at x ≥ 0: pieces closed along the axis,
/// in the direction that they had. Corners on the axis are exactly there. Cost: n log n.
std::vector<std::vector<SectionPoint>> clippedAtAxis(const std::vector<std::vector<SectionPoint>>& outlines);

/// Where the way from a to b meets the axis; x of the two has different signs.
inline SectionPoint onAxis(SectionPoint a, SectionPoint b) { return {0, a.y + (b.y - a.y) * (a.x / (a.x - b.x))}; }

}  // namespace spineloft::geometry
