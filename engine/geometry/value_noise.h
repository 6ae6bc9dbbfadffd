// Smooth noise in space, the same on every platform.
#pragma once

#include <cstdint>

#include "engine/base/vec.h"

namespace spineloft::geometry {

/// Value noise: pseudo-random values −1…1 at the points with whole coordinates, and between them those of the eight
/// around, blended by 3t² − 2t³ in each direction, so that it is C1. Any finite coordinates below 2⁶² in size. Adds and
/// multiplies alone, so that equal arguments give equal bits everywhere.
double valueNoise(ModelPoint at, std::uint32_t seed);

}  // namespace spineloft::geometry
