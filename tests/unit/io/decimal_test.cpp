#include "engine/io/decimal.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>

#include "engine/base/rng.h"

namespace spineloft::io {
namespace {

std::string written(float value) { return std::string(Decimal(value).text()); }

// Digits from the first one that is not zero.
std::ptrdiff_t significant(const std::string& text) {
  const std::size_t first = std::min(text.find_first_of("123456789"), text.size());
  return std::ranges::count_if(text.substr(first), [](char c) { return c != '.'; });
}

}  // namespace

TEST_CASE("a float is written in plain decimals") {
  CHECK(written(0.f) == "0");
  CHECK(written(-0.f) == "0");
  CHECK(written(1) == "1");
  CHECK(written(-20) == "-20");
  CHECK(written(0.1f) == "0.1");
  CHECK(written(-123.456f) == "-123.456");
  CHECK(written(1e-5f) == "0.00001");
  CHECK(written(16777216) == "16777216");
  CHECK(written(std::numeric_limits<float>::denorm_min()).size() <= 64);
  CHECK(written(std::numeric_limits<float>::lowest()).size() <= 64);
}

TEST_CASE("every float is read back as it was, from nine digits at most and never an exponent") {
  Rng rng(7);
  for (int i = 0; i < 40000; ++i) {
    const bool any = i % 2 == 0;
    const auto bits = static_cast<std::uint32_t>(rng.next());
    const float value = any ? std::bit_cast<float>(bits) : static_cast<float>(rng.uniform(-1000, 1000));
    if (!std::isfinite(value)) continue;
    const std::string text = written(value);
    CAPTURE(text);
    CHECK(text.find_first_not_of("-0123456789.") == std::string::npos);
    CHECK((any || significant(text) <= 9));
    CHECK(std::strtof(text.c_str(), nullptr) == value);
  }
}

}  // namespace spineloft::io
