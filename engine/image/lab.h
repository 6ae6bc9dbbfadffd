// Colour as the eye measures it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/image/image.h"

namespace spineloft::image {

/// CIE L*a*b* of an sRGB colour under D65 (CIE 15, IEC 61966-2-1): L 0…100, a and b about −110…110.
std::array<float, 3> labOf(std::uint8_t red, std::uint8_t green, std::uint8_t blue);

/// L*a*b* of every pixel, three floats each, row-major; transparent pixels count as white paper
/// (sRGB values are mixed with white by alpha). Cost: about 10 ms a megapixel.
std::vector<float> labPixels(ImageView image);

}  // namespace spineloft::image
