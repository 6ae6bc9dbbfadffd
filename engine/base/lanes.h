// Four floats at a time, in the words of both compilers: SSE, or SIMD of WebAssembly; and what loops
// over floats need that compilers cannot make SIMD of.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>

namespace spineloft {

using Float4 = float __attribute__((vector_size(16)));
using Long2 = std::int64_t __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

inline Float4 load4(const float* from) {
  Float4 v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}
inline Float4 load4(const std::int16_t* from) {
  using Short4 = std::int16_t __attribute__((vector_size(8)));
  Short4 v;
  __builtin_memcpy(&v, from, sizeof v);
  return __builtin_convertvector(v, Float4);
}
inline void store4(Float4 v, float* to) { __builtin_memcpy(to, &v, sizeof v); }
inline Float4 all4(float v) { return Float4{v, v, v, v}; }
inline Float4 least4(Float4 a, Float4 b) { return a < b ? a : b; }
inline Float4 most4(Float4 a, Float4 b) { return a > b ? a : b; }
inline Float4 magnitude4(Float4 v) {
  return std::bit_cast<Float4>(std::bit_cast<Int4>(v) & Int4{0x7FFFFFFF, 0x7FFFFFFF, 0x7FFFFFFF, 0x7FFFFFFF});
}
/// In which lanes a comparison holds: bit i for lane i.
inline unsigned lanes4(Int4 held) {
#if defined(__wasm_simd128__)
  return static_cast<unsigned>(__builtin_wasm_bitmask_i32x4(held));
#elif defined(__SSE__)
  return static_cast<unsigned>(__builtin_ia32_movmskps(std::bit_cast<Float4>(held)));
#else
  return (held[0] & 1u) | (held[1] & 2u) | (held[2] & 4u) | (held[3] & 8u);
#endif
}
/// Whether any lane of a comparison holds.
inline bool any4(Int4 held) { return lanes4(held) != 0; }
inline float sum4(Float4 v) { return (v[0] + v[1]) + (v[2] + v[3]); }
/// Where the lesser of single floats is a branch, that of lanes is one instruction.
inline float lesser(float a, float b) { return a < b ? a : b; }
/// The least of `count` values, infinity if there are none.
inline float leastOf(const float* values, std::size_t count) {
  Float4 least = all4(std::numeric_limits<float>::infinity());
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4) least = least4(load4(values + i), least);
  float best = lesser(lesser(least[0], least[1]), lesser(least[2], least[3]));
  for (; i < count; ++i) best = lesser(values[i], best);
  return best;
}

/// atan(√w) / √w on [0, 1], interpolated at Chebyshev nodes: relative error below 2e-7.
inline constexpr std::array<float, 8> kArctanTerms{0.999999882f,  -0.333318127f,  0.199669618f,  -0.140032902f,
                                                   0.0986886546f, -0.0588297531f, 0.0237805186f, -0.00455979199f};
inline Float4 arctanOverArgument(Float4 w) {
  Float4 sum = all4(kArctanTerms[7]);
  for (std::size_t i = 7; i-- > 0;) sum = sum * w + all4(kArctanTerms[i]);
  return sum;
}
/// atan q for q > 0, as near.
inline double quickArctan(double q) {
  const double z = q < 1 ? q : 1 / q, w = z * z;
  double sum = static_cast<double>(kArctanTerms[7]);
  for (std::size_t i = 7; i-- > 0;) sum = sum * w + static_cast<double>(kArctanTerms[i]);
  return q < 1 ? z * sum : std::numbers::pi / 2 - z * sum;
}

/// log x for x > 0 that is neither denormal nor infinite: within 2e-7, relative beyond 1.
/// x = 2^e m with √½ ≤ m < √2, and log m = 2 artanh((m − 1) / (m + 1)) by its series.
inline float quickLog(float x) {
  constexpr std::int32_t kRootHalf = 0x3F3504F3, kMantissa = 0x007FFFFF;
  const std::int32_t bits = std::bit_cast<std::int32_t>(x) - kRootHalf;
  const auto e = static_cast<float>(bits >> 23);
  const float m = std::bit_cast<float>((bits & kMantissa) + kRootHalf);
  const float z = (m - 1) / (m + 1), w = z * z;
  const float series = 1 + w * (1.f / 3 + w * (1.f / 5 + w * (1.f / 7 + w * (1.f / 9))));
  return e * 0.693147181f + 2 * z * series;
}

/// e^x within a relative 3e-7 for −87 ≤ x ≤ 87, what is beyond taken for the bound.
/// x = n log 2 + r with |r| ≤ ½ log 2, and e^r by its series.
inline float quickExp(float x) {
  constexpr float kRounder = 12582912;  // 1.5 · 2²³: a sum with it is a whole number
  const float low = x < -87 ? -87.f : x, held = low > 87 ? 87.f : low;
  const float sum = held * 1.44269504f + kRounder, n = sum - kRounder;
  const float r = (held - n * 0.693145752f) - n * 1.42860677e-6f;
  const float series = 1 + r * (1 + r * (1.f / 2 + r * (1.f / 6 + r * (1.f / 24 + r * (1.f / 120 + r * (1.f / 720))))));
  const std::int32_t power = std::bit_cast<std::int32_t>(sum) - std::bit_cast<std::int32_t>(kRounder);
  return series * std::bit_cast<float>((power + 127) << 23);
}

}  // namespace spineloft
