// A stroke that a link has room for. Internal to publish/.
#pragma once

#include <utility>
#include <vector>

#include "engine/image/image.h"
#include "engine/ribs/base/spine.h"

namespace spineloft::publish {

/// A stroke, and the spine that it is cleaned to.
struct StrokeAndSpine {
  std::vector<PicturePoint> stroke;
  ribs::Spine spine;
};

/// As few evenly spaced points, as a share text keeps them (io::keptLine), as give the same spine to within one pixel
/// of a picture of 1024 pixels, point by point: rib ends that are fixed beside it are measured from it, and the solid
/// stands on them. `given` where none do, with its stroke as a text keeps it. Cost: some dozen spines.
StrokeAndSpine shortStroke(const StrokeAndSpine& given, image::Size picture, const ribs::SpineParams& params);

}  // namespace spineloft::publish
