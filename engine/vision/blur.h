// A picture out of focus.
#pragma once

#include "engine/base/result.h"
#include "engine/image/image.h"

namespace spineloft::vision {

/// All four channels under a Gaussian (OpenCV's) of `sigma` pixels, 0 < sigma ≤ 1000, as far as 3 σ; beyond the frame
/// its pixels go on. Errors: PictureEmpty, ValueOutOfRange, OutOfMemory.
Result<image::Image> blurred(const image::Image& image, double sigma);

}  // namespace spineloft::vision
