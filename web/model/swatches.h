// The plain colours on offer.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace spineloft::app {

struct Swatch {
  unsigned hex;
  std::string_view value, label;
};

constexpr std::array<std::uint8_t, 3> rgbOf(const Swatch& swatch) {
  const auto byte = [&](unsigned shift) { return static_cast<std::uint8_t>((swatch.hex >> shift) & 0xff); };
  return {byte(16), byte(8), byte(0)};
}

inline constexpr std::array kSwatches = {
    Swatch{0xec9e5c, "#ec9e5c", "Apricot"}, Swatch{0xe4572e, "#e4572e", "Orange red"},
    Swatch{0xf2c14e, "#f2c14e", "Yellow"},  Swatch{0x76b041, "#76b041", "Green"},
    Swatch{0x2a9d8f, "#2a9d8f", "Teal"},    Swatch{0x4a90d9, "#4a90d9", "Blue"},
    Swatch{0x7b61c4, "#7b61c4", "Violet"},  Swatch{0xd9699f, "#d9699f", "Pink"},
    Swatch{0xf1ede4, "#f1ede4", "White"},   Swatch{0x4a4e5a, "#4a4e5a", "Grey"},
};

}  // namespace spineloft::app
