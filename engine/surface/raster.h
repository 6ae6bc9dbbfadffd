// Triangles to pixels.
#pragma once

#include <array>

#include "engine/base/vec.h"
#include "engine/image/image.h"

namespace spineloft::surface {

/// Sets the pixels of `mask` to 255 whose centres (integers, y down) the triangle covers, whichever way
/// round it runs. Triangles that share an edge leave no gap and a centre on an edge belongs to the
/// triangle on its right or below (top-left rule). What lies outside the mask is cut off; corners must
/// be finite. Cost: rows and pixels that it covers.
void coverTriangle(const std::array<PicturePoint, 3>& corners, image::Mask& mask);

}  // namespace spineloft::surface
