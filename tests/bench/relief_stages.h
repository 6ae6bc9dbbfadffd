// Times of reliefs.
#pragma once

#include "tests/bench/report.h"

namespace spineloft::bench {

/// Heights from ink, brightness, and light and shadow of a dome of 128 and of 256 cells, and its mesh raised by them.
void reportReliefStages(Report& report);

}  // namespace spineloft::bench
