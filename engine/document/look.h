// How a surface looks.
#pragma once

#include <array>
#include <cstdint>

namespace spineloft::document {

/// How a part's surface looks.
struct Look {
  bool textured = true;                              ///< the picture on the surface, else `colour`
  std::array<std::uint8_t, 3> colour{236, 158, 92};  ///< sRGB
  bool operator==(const Look&) const = default;
};

}  // namespace spineloft::document
