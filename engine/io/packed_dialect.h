// What the versions of packed JSON differ in, and what both sides know beforehand. Internal to packed_json.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "engine/io/bit_coder.h"

namespace spineloft::io {

/// Models that are examples too: tracedModels (packed_traces.h) or linkedModels (packed_links.h).
enum class Traced : std::uint8_t { None, Ribs, RibsAndFans, Linked };

/// What the versions of the text differ in.
struct Dialect {
  std::size_t modes;  ///< so many of kModes
  int modeBits;       ///< of the number of a mode
  int divisorBits;    ///< of the number of a divisor
  /// kOther, Kind::Colour, a bit for what is as in the row above, lists of multiples of a power of two, words that were
  /// spelled before, and a difference is coded after what the two before tell.
  bool later;
  bool near;  ///< and after how far the two numbers before are from the expected one
  Pace pace;
  std::array<std::string_view, 8> examples;  ///< what both sides know beforehand, what is most usual last
  Traced traced;                             ///< and then these models, whose words are spelled
  bool halved;                               ///< a row in the middle of a table may begin anew
  bool greyColours = false;                  ///< of a colour green, and what red and blue differ from it
};
const Dialect& dialectOf(int version);

/// The examples, and the words in them: a word is coded by its number, others by their letters.
struct Example {
  std::vector<nlohmann::json> documents;
  std::vector<std::string> words;
};
const Example& exampleOf(int version);

}  // namespace spineloft::io
