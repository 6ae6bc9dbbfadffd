// The checksum of ZIP and PNG.
#pragma once

#include <cstdint>
#include <span>

namespace spineloft {

/// CRC-32 (ISO 3309) of the bytes; 0 of none.
std::uint32_t crc32(std::span<const std::uint8_t> bytes);

}  // namespace spineloft
