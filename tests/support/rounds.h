// How many random rounds a test runs.
#pragma once

#include <cstdint>
#include <ranges>

namespace spineloft::testing {

/// `few` rounds, times $SPINELOFT_ROUNDS where it is set (1…1000): npm run test:all runs many times as many.
int rounds(int few);

/// The seeds first … last − 1, and those after them in as many more rounds.
inline auto seeds(std::uint64_t first, std::uint64_t last) {
  return std::views::iota(first, first + static_cast<std::uint64_t>(rounds(static_cast<int>(last - first))));
}

/// Whether this run takes a seed of a long test: every one, or where $SPINELOFT_SEEDS says so the even or the odd ones.
bool takes(std::uint64_t seed);
/// Those of `seeds` that this run takes: `npm test` shares them out between two builds.
inline auto sharedSeeds(std::uint64_t first, std::uint64_t last) {
  return seeds(first, last) | std::views::filter(takes);
}

}  // namespace spineloft::testing
