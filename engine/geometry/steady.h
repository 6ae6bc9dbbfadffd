// Outlines without the tremor of a hand and the steps of pixels.
#pragma once

#include "engine/geometry/region.h"

namespace spineloft::geometry {

/// How far outlines are evened out, picture pixels.
struct Steadiness {
  double reach = 0;  ///< along the outline, to both sides, > 0
  double most = 0;   ///< how far a point may go for it
};

/// Every outline through the means of what lies within the reach on both sides of its points.
/// Corners, where it turns by more than kSteadyCorner within the reach, stay, and nothing is evened
/// out across them, so that polygons keep their shape. Short outlines stay as they are, and all of
/// them when the region would not be simple any more. `contours` as cleanRegion gives them; so is
/// the result. Linear, about.
Contours steadied(const Contours& contours, const Steadiness& steadiness);

inline constexpr double kSteadyCorner = 0.45;  ///< radians

}  // namespace spineloft::geometry
