// How many random rounds a test runs.
#pragma once

#include <cstdint>

namespace spineloft::testing {

/// `few` rounds, times $SPINELOFT_ROUNDS where it is set (1…1000): npm run test:all runs many times as many.
std::uint64_t rounds(std::uint64_t few);

}  // namespace spineloft::testing
