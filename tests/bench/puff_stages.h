// Times of puffs, soft ones and those with a slice.
#pragma once

#include "tests/bench/report.h"

namespace spineloft::bench {

/// A blob, a hand and a star: soft, with a new outline, while a slice is dragged, and the bones; as ratios to the soft
/// puff of as many points.
void reportPuffStages(Report& report);

}  // namespace spineloft::bench
