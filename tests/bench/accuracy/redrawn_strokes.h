// The strokes of a case drawn anew, as another hand would: whether what was chosen on a folder's own strokes holds
// for others.
#pragma once

#include <cstdint>

#include "engine/io/json_values.h"

namespace spineloft::accuracy {

/// Replaces the strokes named careful, sloppy and offcentre (others stay) by lines along the true middle line, between
/// the ends of the careful one: careful wanders by up to 3 % of the local width; sloppy by up to 12 % with a tremor of
/// 1 %, each end up to a quarter of the width short; offcentre keeps 22 % of the width to one side, give or take 5 %:
/// which side is drawn by lot for every case, as is the direction. The lots depend on `seed` and the case's id alone. A
/// case without a careful stroke stays as it is.
void redrawStrokes(io::BenchCase& one, std::uint64_t seed);

}  // namespace spineloft::accuracy
