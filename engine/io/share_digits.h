// Bytes as letters, digits, '-' and '_' (base64url: RFC 4648, section 5, without padding). Internal to io/.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace spineloft::io {

inline constexpr std::string_view kDigits64 = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
/// 0 … 63; -1 of any other character.
int digitOf(char c);

std::string toText(std::span<const std::uint8_t> bytes);
/// None when a character is no digit, or bits are left over that are not 0.
std::optional<std::vector<std::uint8_t>> toBytes(std::string_view text);

}  // namespace spineloft::io
