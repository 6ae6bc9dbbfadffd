#include "engine/base/short_lanes.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "engine/base/rng.h"

using namespace spineloft;

namespace {

std::array<std::int16_t, 8> shorts(Rng& rng) {
  std::array<std::int16_t, 8> all{};
  for (std::int16_t& one : all) one = static_cast<std::int16_t>(std::lround(rng.uniform(-32768, 32767)));
  return all;
}

}  // namespace

TEST_CASE("sums of two products each are those of whole numbers, at the ends of their range, too") {
  Rng rng(1);
  for (int round = 0; round < 50; ++round) {
    std::array<std::int16_t, 8> a = shorts(rng), b = shorts(rng);
    if (round == 0) a.fill(-32768), b.fill(32767);
    const Int4 sums = dotPairs(load8(a.data()), load8(b.data()));
    const Int4 same = dotPairs(pair8(&a[2]), load8(b.data()));
    for (std::size_t i = 0; i < 4; ++i) {
      CHECK(sums[i] == a[2 * i] * b[2 * i] + a[2 * i + 1] * b[2 * i + 1]);
      CHECK(same[i] == a[2] * b[2 * i] + a[3] * b[2 * i + 1]);
    }
  }
}

TEST_CASE("values go to the nearest whole number and are held to 16 bits") {
  const Int4 near = nearest4(Float4{-2.5f, 0.49f, 1.5f, -7.6f});
  CHECK(near[0] == -2);
  CHECK(near[1] == 0);
  CHECK(near[2] == 2);
  CHECK(near[3] == -8);
  std::array<std::int16_t, 8> out{};
  storeShort8(Int4{-40000, -32768, -1, 0}, Int4{1, 32767, 32768, 1 << 20}, out.data());
  const std::array<std::int16_t, 8> expected{-32768, -32768, -1, 0, 1, 32767, 32767, 32767};
  CHECK(out == expected);
}
