// Small copies of photos as links carry them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "engine/io/picture_file.h"
#include "tests/support/random_documents.h"

namespace spineloft::testing {

inline constexpr std::string_view kDigits64 = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

/// RFC 4648, section 5, without padding: bit by bit.
inline std::string base64url(std::span<const std::uint8_t> bytes) {
  std::string text;
  for (std::size_t bit = 0; bit < 8 * bytes.size(); bit += 6) {
    std::size_t digit = 0;
    for (std::size_t at = bit; at < bit + 6; ++at) {
      digit = 2 * digit + (at < 8 * bytes.size() ? bytes[at / 8] >> (7 - at % 8) & 1U : 0U);
    }
    text += kDigits64[digit];
  }
  return text;
}

/// An ellipse on a picture of this size as a JPEG.
inline std::string jpegCopy(int width, int height) {
  return base64url(io::encodeJpeg(ellipsePicture(width, height)->working, 60).value());
}

}  // namespace spineloft::testing
