// Times of pulls.
#pragma once

#include "tests/bench/report.h"

namespace spineloft::bench {

/// A line on a puff with about 2,000 vertices that follow: made anew, and moved to another height.
void reportPullStages(Report& report);

}  // namespace spineloft::bench
