// How a surface looks.
#pragma once

#include <array>
#include <cstdint>

#include "engine/surface/finish.h"

namespace spineloft::document {

/// How a part's surface looks.
struct Look {
  bool textured = true;                               ///< the picture on the surface, else `colour`
  std::array<std::uint8_t, 3> colour{236, 158, 92};   ///< sRGB
  surface::Paint paint = surface::Paint::Plain;       ///< of a part without the picture
  std::array<std::uint8_t, 3> second{241, 237, 228};  ///< sRGB; below, with Paint::TwoTone
  bool faceted = false;                               ///< every triangle flat, else smooth
  bool inked = false;                                 ///< on paper: the ink of its outline stays on the surface
  bool operator==(const Look&) const = default;
};

}  // namespace spineloft::document
