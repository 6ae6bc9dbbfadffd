// Times of line drawings, from lines to solids.
#pragma once

#include "tests/bench/report.h"

namespace spineloft::bench {

/// Orders of 16 pieces; depths of 22 round pieces, 1,122 unknowns; a woven mat; a drawing of 8 pieces as a whole.
void reportDrawingStages(Report& report);

}  // namespace spineloft::bench
