#include "web/model/colour_text.h"

#include <cstdio>

namespace spineloft::app {

std::optional<std::array<std::uint8_t, 3>> colourFrom(std::string_view text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  std::array<std::uint8_t, 3> colour{};
  for (std::size_t i = 0; i < 3; ++i) {
    int value = 0;
    for (std::size_t k = 1 + 2 * i; k < 3 + 2 * i; ++k) {
      const char c = text[k];
      const bool digit = c >= '0' && c <= '9', lower = c >= 'a' && c <= 'f', upper = c >= 'A' && c <= 'F';
      if (!digit && !lower && !upper) return std::nullopt;
      value = value * 16 + (digit ? c - '0' : (lower ? c - 'a' : c - 'A') + 10);
    }
    colour[i] = static_cast<std::uint8_t>(value);
  }
  return colour;
}

std::string colourText(const std::array<std::uint8_t, 3>& colour) {
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", colour[0], colour[1], colour[2]);
  return text;
}

}  // namespace spineloft::app
