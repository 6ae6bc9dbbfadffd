// Times of bridges.
#pragma once

#include "tests/bench/report.h"

namespace spineloft::bench {

/// A bridge between two balls, and a handle on one.
void reportBridgeStages(Report& report);

}  // namespace spineloft::bench
