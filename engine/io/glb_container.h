// The outer form of a GLB (glTF 2.0, "Binary glTF"): a header, a JSON chunk, a binary chunk. Any bytes
// are safe to read. Internal to io/.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "engine/base/result.h"
#include "engine/io/export_part.h"

namespace spineloft::io {

/// Views into the file.
struct GlbChunks {
  std::string_view json;
  std::span<const std::uint8_t> binary;  ///< empty where there is none
};

/// None for anything but a whole GLB of version 2; what follows its declared end is not looked at.
std::optional<GlbChunks> readGlbChunks(std::span<const std::uint8_t> glb);

/// Whether the file begins as a GLB and ends before the length that it states.
bool isCutOff(std::span<const std::uint8_t> glb);

/// What there is of the JSON chunk, also when the file is cut off or its sizes are wrong; empty for what
/// does not begin as a GLB.
std::string_view jsonOfGlb(std::span<const std::uint8_t> glb);

/// Error: OutOfMemory (over 4 GiB, which a GLB cannot hold).
Result<Bytes> writeGlbChunks(const GlbChunks& chunks);

}  // namespace spineloft::io
