#include "tests/support/rounds.h"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace spineloft::testing {

int rounds(int few) {
  static const int kTimes = [] {
    const char* times = std::getenv("SPINELOFT_ROUNDS");
    return times == nullptr ? 1 : std::clamp(std::atoi(times), 1, 1000);
  }();
  return few * kTimes;
}

bool takes(std::uint64_t seed) {
  static const std::string kSeeds = [] {
    const char* seeds = std::getenv("SPINELOFT_SEEDS");
    return std::string(seeds == nullptr ? "" : seeds);
  }();
  return kSeeds.empty() || (kSeeds == "odd") == (seed % 2 == 1);
}

}  // namespace spineloft::testing
