#include "tests/support/rounds.h"

#include <algorithm>
#include <cstdlib>

namespace spineloft::testing {

std::uint64_t rounds(std::uint64_t few) {
  const char* times = std::getenv("SPINELOFT_ROUNDS");
  return few * static_cast<std::uint64_t>(times == nullptr ? 1 : std::clamp(std::atoi(times), 1, 1000));
}

}  // namespace spineloft::testing
