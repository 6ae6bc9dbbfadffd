// How ends of lofted solids are finished.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace spineloft::sections {

/// How an end of the part is finished. Values are saved in files: only ever append.
enum class CapStyle : std::uint8_t {
  Flat,     ///< cut straight across: at the last rib, or where the spine ends when ribs bend round that
            ///< end by more than a quarter of the half width
  Round,    ///< a dome beyond the last rib that follows the end fan where there is one, as far as it
            ///< lies beyond the rib and between the sides where they close
  Pointed,  ///< runs out into a tip
  Open,     ///< a hollow mouth: cut like a flat end, then the wall turns inwards and closes inside, so that the
            ///< solid stays closed and printable
  kCount
};
struct CapName {
  CapStyle style;
  std::string_view key, label;
};
std::span<const CapName> capNames();
std::optional<CapStyle> capFromKey(std::string_view key);
std::string_view capKey(CapStyle style);

/// Height of a dome without a fan, in half widths.
inline constexpr double kDomeHeight = 0.6;
/// Length of a point without a fan, in half widths.
inline constexpr double kPointLength = 2.0;
/// Thickness of the wall of an open end, in half widths.
inline constexpr double kWall = 0.2;
/// How far an open end is hollow, as a share of the part's length.
inline constexpr double kMouthDepth = 0.9;
}  // namespace spineloft::sections
