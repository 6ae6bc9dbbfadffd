// Text as people write it: UTF-8.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace spineloft {

/// Bytes of the valid UTF-8 character that begins at `at` (Unicode 15, table 3-7); 0 when there is
/// none.
std::size_t utf8CharacterAt(std::string_view text, std::size_t at);

/// The text with every byte that is not part of valid UTF-8 replaced by '?'.
std::string validUtf8(std::string text);

/// As people write a number: at most six digits, no zeros at the end ("0.05", "4").
std::string shortNumber(double value);

}  // namespace spineloft
