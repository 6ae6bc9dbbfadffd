// The connected pieces of a region.
#pragma once

#include <vector>

#include "engine/geometry/region.h"

namespace spineloft::geometry {

/// Each outer outline of a cleaned region (cleanRegion) with the holes whose smallest outline round them it is, the
/// outer one first; in the order of the outer ones. Cost: outlines squared, times their points.
std::vector<Contours> piecesOf(const Contours& contours);

}  // namespace spineloft::geometry
