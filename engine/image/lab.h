// Colour as the eye measures it.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace spineloft::image {

/// CIE L*a*b* of an sRGB colour under D65 (CIE 15, IEC 61966-2-1): L 0…100, a and b about −110…110.
std::array<float, 3> labOf(std::uint8_t red, std::uint8_t green, std::uint8_t blue);

/// Where the L*, a* and b* of a row of pixels go: one float a pixel each.
struct LabPlanes {
  float *l, *a, *b;
};

/// L*a*b* of RGBA pixels (four bytes each), channel by channel; transparent pixels count as white
/// paper (sRGB values are mixed with white by alpha). Cost: about 5 ms a megapixel.
void labRow(std::span<const std::uint8_t> pixels, const LabPlanes& out);

}  // namespace spineloft::image
