#include "engine/base/crc32.h"

#include <doctest/doctest.h>

#include <array>

using namespace spineloft;

TEST_CASE("the checksum of 123456789 is cbf43926") {
  const std::array<std::uint8_t, 9> digits{'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  CHECK(crc32(digits) == 0xcbf43926u);
  CHECK(crc32({}) == 0u);
}
