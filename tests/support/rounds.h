// How many random rounds a test runs.
#pragma once

#include <cstdint>
#include <ranges>

namespace spineloft::testing {

/// `few` rounds, times $SPINELOFT_ROUNDS where it is set (1…1000): npm run test:all runs many times as many.
int rounds(int few);

/// Whether this run takes a seed: every one, or where $SPINELOFT_SEEDS says so the even or the odd ones. `npm test`
/// shares seeds out between two builds.
bool takes(std::uint64_t seed);
/// Of the seeds first … last − 1, and those after them in as many more rounds, the ones that this run takes.
inline auto seeds(std::uint64_t first, std::uint64_t last) {
  const auto count = static_cast<std::uint64_t>(rounds(static_cast<int>(last - first)));
  return std::views::iota(first, first + count) | std::views::filter(takes);
}

}  // namespace spineloft::testing
