// A stroke that a link has room for. Internal to publish/.
#pragma once

#include <cstddef>
#include <functional>
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

/// What else a text says beside a stroke costs so much, in the unit of io::lineCost.
using CostBesides = std::function<std::size_t(const StrokeAndSpine&)>;

/// The evenly spaced points of fewest characters, as a share text keeps them (io::keptLine), that give the same spine
/// to within one pixel of a picture of 1024 pixels, point by point: rib ends that are fixed beside it are measured
/// from it, and the solid stands on them. `given` where none do, with its stroke as a text keeps it. Cost: up to 304
/// spines.
StrokeAndSpine shortStroke(const StrokeAndSpine& given, image::Size picture, const ribs::SpineParams& params,
                           const CostBesides& besides);

}  // namespace spineloft::publish
