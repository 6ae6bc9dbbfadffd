// Colours as the page writes them: "#rrggbb", sRGB.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace spineloft::app {

/// None for anything but '#' and six hexadecimal digits.
std::optional<std::array<std::uint8_t, 3>> colourFrom(std::string_view text);
std::string colourText(const std::array<std::uint8_t, 3>& colour);

}  // namespace spineloft::app
