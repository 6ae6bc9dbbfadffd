// JSON in few bytes: keys, texts and numbers come back equal. Internal to io/.
//
// Keys, words and numbers are coded with what was seen at the same key before (bit_coder.h). A list of numbers is
// coded as differences, to the number before or to the line through the two before, one or two places back (so that
// x, y, x, y … works as well as a plain list), or by the turn of a line of points, or of even steps (foretold.h); a
// list of lists of equal length is coded column by column. What both sides know beforehand is an example of a document,
// which is coded first and thrown away.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "engine/base/result.h"

namespace spineloft::io {

/// Most values, list entries and bytes of text together in what is unpacked, and its deepest nesting.
inline constexpr std::size_t kMostPacked = std::size_t{1} << 21;
inline constexpr int kMostPackedDepth = 32;

/// What packJson writes if it is not told otherwise; 1 … this are read.
inline constexpr int kPackedVersion = 6;

/// What is packed and read at most.
struct PackBounds {
  std::size_t values = kMostPacked;
  int depth = kMostPackedDepth;
};

/// Numbers that are not finite become null. Errors: OutOfMemory (more than the bounds). What is packed with wider
/// bounds than the usual ones is refused by unpackJson.
Result<std::vector<std::uint8_t>> packJson(const nlohmann::json& value, const PackBounds& bounds = {},
                                           int version = kPackedVersion);
/// Bytes that packJson did not write give some other value, or an error: ProjectInvalid (not UTF-8, or larger than
/// packJson writes), ProjectTooNew. The work and the memory are bounded by kMostPacked.
Result<nlohmann::json> unpackJson(std::span<const std::uint8_t> bytes, int version = kPackedVersion);

/// Whether a key or a text is coded as one symbol; others are spelled.
bool isPackedWord(std::string_view text);

}  // namespace spineloft::io
