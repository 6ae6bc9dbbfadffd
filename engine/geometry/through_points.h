// A smooth curve through points. Internal to the engine.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/base/vec.h"

namespace spineloft::geometry {

/// A smooth curve through all of ≥ 3 points but the first and the last one, which only steer (cubic Hermite, slopes of
/// parabolas by chord length): `steps` ≥ 1 pieces between neighbours. `out` is replaced.
void throughPoints(std::span<const PicturePoint> points, std::size_t steps, std::vector<PicturePoint>& out);

}  // namespace spineloft::geometry
