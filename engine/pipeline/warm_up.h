// Runs every stage once, so that the first stroke does not pay for compilation and first allocations.
#pragma once

#include "engine/base/result.h"

namespace spineloft::pipeline {

/// Runs edges, ribs and loft on a tiny picture that is made here, as often as `rounds` (1…100) says,
/// and forgets the results. Browsers run WebAssembly first in a slow tier and replace a function by a
/// faster one after some calls: with this the first stroke meets the fast ones. A few
/// milliseconds a round. Errors: those of the stages, which are OutOfMemory at most.
Status warmUp(int rounds);

}  // namespace spineloft::pipeline
