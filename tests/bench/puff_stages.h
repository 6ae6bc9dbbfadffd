// Times of puffs, soft ones and those with a slice.
#pragma once

#include "engine/geometry/region.h"
#include "tests/bench/report.h"

namespace spineloft::bench {

/// Of 400 pixels, hand-drawn, in a picture of 500 x 500: 300 points.
geometry::Contours blob();

/// A blob, a hand and a star: soft, with a new outline, while a slice is dragged, and the bones; as ratios to the soft
/// puff of as many points.
void reportPuffStages(Report& report);

}  // namespace spineloft::bench
