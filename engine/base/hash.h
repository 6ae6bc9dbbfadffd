// 64-bit content hashes that key the caches. Not cryptographic; equal input gives equal output on
// every platform of equal endianness.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

namespace spineloft {

/// Collects values in order; the order and the types are part of the hash.
class Hasher {
 public:
  /// Mixes `bytes` in, eight at a time (word-wise multiply and rotate).
  Hasher& bytes(std::span<const std::byte> bytes);
  Hasher& text(std::string_view text) {
    number(text.size());
    return bytes(std::as_bytes(std::span(text.data(), text.size())));
  }
  /// Any number or enum. Floating-point −0 and +0 hash alike; so does every NaN.
  template <class T>
    requires(std::is_arithmetic_v<T> || std::is_enum_v<T>)
  Hasher& number(T value) {
    if constexpr (std::is_floating_point_v<T>) {
      double d = static_cast<double>(value);
      if (d == 0) d = 0;
      mix(d != d ? 0x7ff8000000000000ull : std::bit_cast<std::uint64_t>(d));
    } else {
      mix(static_cast<std::uint64_t>(value));
    }
    return *this;
  }
  std::uint64_t value() const;

 private:
  void mix(std::uint64_t word);
  std::uint64_t state_ = 0x9e3779b97f4a7c15ull;
};

}  // namespace spineloft
