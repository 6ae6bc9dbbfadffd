// The curve of sRGB.
#pragma once

#include <cmath>

namespace spineloft::image {

/// Of a channel, both 0…1.
inline double linearOfSrgb(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

}  // namespace spineloft::image
