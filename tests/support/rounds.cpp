#include "tests/support/rounds.h"

#include <algorithm>
#include <cstdlib>

namespace spineloft::testing {

int rounds(int few) {
  static const int kTimes = [] {
    const char* times = std::getenv("SPINELOFT_ROUNDS");
    return times == nullptr ? 1 : std::clamp(std::atoi(times), 1, 1000);
  }();
  return few * kTimes;
}

}  // namespace spineloft::testing
