// A made-up picture to measure on: the same on every machine, with what photos have.
#pragma once

#include <vector>

#include "engine/base/vec.h"
#include "engine/image/image.h"

namespace spineloft::bench {

/// A bent, tapering, striped tube on textured ground with noise; seeded.
image::Picture tubePicture(image::Size size);

/// The middle line of that tube, `count` points.
std::vector<PicturePoint> tubeStroke(image::Size size, int count);

}  // namespace spineloft::bench
