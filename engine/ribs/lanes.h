// Four floats at a time, in the words of both compilers: SSE, or SIMD of WebAssembly.
#pragma once

#include <cstdint>

namespace spineloft::ribs {

using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

inline Float4 load4(const float* from) {
  Float4 v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}
inline void store4(Float4 v, float* to) { __builtin_memcpy(to, &v, sizeof v); }
inline Float4 all4(float v) { return Float4{v, v, v, v}; }
inline Float4 least4(Float4 a, Float4 b) { return a < b ? a : b; }
inline Float4 most4(Float4 a, Float4 b) { return a > b ? a : b; }
inline Float4 magnitude4(Float4 v) { return v < all4(0) ? -v : v; }
inline float sum4(Float4 v) { return (v[0] + v[1]) + (v[2] + v[3]); }

}  // namespace spineloft::ribs
