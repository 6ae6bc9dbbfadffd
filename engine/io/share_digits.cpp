#include "engine/io/share_digits.h"

namespace spineloft::io {

int digitOf(char c) {
  const std::size_t at = kDigits64.find(c);
  return at == std::string_view::npos ? -1 : static_cast<int>(at);
}

std::string toText(std::span<const std::uint8_t> bytes) {
  std::string text;
  std::uint32_t bits = 0;
  int held = 0;
  for (const std::uint8_t byte : bytes) {
    bits = bits << 8 | byte;
    for (held += 8; held >= 6; held -= 6) text += kDigits64[bits >> (held - 6) & 63];
  }
  if (held > 0) text += kDigits64[bits << (6 - held) & 63];
  return text;
}

std::optional<std::vector<std::uint8_t>> toBytes(std::string_view text) {
  std::vector<std::uint8_t> bytes;
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : text) {
    const int digit = digitOf(c);
    if (digit < 0) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes.push_back(static_cast<std::uint8_t>(bits >> held));
  }
  const bool rest = held >= 6 || (bits & ((1U << held) - 1)) != 0;
  return rest ? std::nullopt : std::optional(std::move(bytes));
}

}  // namespace spineloft::io
