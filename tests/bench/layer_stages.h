// Times of parts made of layers, and of spun ones.
#pragma once

#include "tests/bench/report.h"

namespace spineloft::bench {

/// A vase, a Y and a hand, with and without rounded forks, and a spun bowl; as ratios to a loft of as many triangles.
void reportLayerStages(Report& report);

}  // namespace spineloft::bench
