// Numbers as text, the same in every locale. Internal to io/.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace spineloft::io {

/// A float in plain decimals, without an exponent.
class Decimal {
 public:
  /// `value` finite. As few digits as give back the same float (Grisu2: in one of a thousand one digit more); −0 is 0.
  /// Not std::to_chars: its tables for every length of double are 100 KB of a WebAssembly program.
  explicit Decimal(float value);
  std::string_view text() const { return {text_.data(), size_}; }

 private:
  void add(std::string_view more);
  void addZeros(int count);
  std::array<char, 64> text_;  ///< at most a sign, "0.", 44 zeros and 9 digits
  std::size_t size_ = 0;
};

}  // namespace spineloft::io
