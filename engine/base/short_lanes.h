// Eight 16-bit integers at a time: twice as many products an instruction as lanes.h has of floats, and sums that are
// exact, hence equal on every machine.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "engine/base/lanes.h"

namespace spineloft {

using Short8 = std::int16_t __attribute__((vector_size(16)));

inline Short8 load8(const std::int16_t* from) {
  Short8 v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}
/// Two neighbouring entries, four times.
inline Short8 pair8(const std::int16_t* from) {
  float both = 0;  // bits; floats are repeated with fewer instructions of SSE
  __builtin_memcpy(&both, from, sizeof both);
  return std::bit_cast<Short8>(all4(both));
}
/// a₀b₀ + a₁b₁, a₂b₂ + a₃b₃, …: exact unless all four entries of a sum are −32768.
inline Int4 dotPairs(Short8 a, Short8 b) {
#if defined(__wasm_simd128__)
  return __builtin_wasm_dot_s_i32x4_i16x8(a, b);
#elif defined(__SSE2__)
  return __builtin_ia32_pmaddwd128(a, b);
#else
  Int4 sums{};
  for (int i = 0; i < 4; ++i) sums[i] = a[2 * i] * b[2 * i] + a[2 * i + 1] * b[2 * i + 1];
  return sums;
#endif
}
/// The nearest integers of values within ±2²², halves to the even one.
inline Int4 nearest4(Float4 v) {
  constexpr float kRounder = 12582912;  // 1.5 · 2²³: a sum with it is a whole number
  return std::bit_cast<Int4>(v + kRounder) - std::bit_cast<std::int32_t>(kRounder);
}
/// Both as 16 bits, held to what these can say, one after the other.
inline void storeShort8(Int4 a, Int4 b, std::int16_t* to) {
#if defined(__wasm_simd128__)
  const Short8 v = __builtin_wasm_narrow_s_i16x8_i32x4(a, b);
#elif defined(__SSE2__)
  const Short8 v = __builtin_ia32_packssdw128(a, b);
#else
  Short8 v{};
  const auto held = [](std::int32_t x) {
    return static_cast<std::int16_t>(x < -32768 ? -32768 : x > 32767 ? 32767 : x);
  };
  for (int i = 0; i < 4; ++i) v[i] = held(a[i]), v[4 + i] = held(b[i]);
#endif
  __builtin_memcpy(to, &v, sizeof v);
}

}  // namespace spineloft
