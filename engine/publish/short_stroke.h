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

/// A stroke of few characters, as a share text keeps it (io::keptLine), that gives the same spine to within one pixel
/// of a picture of 1024 pixels, point by point: rib ends that are fixed beside it are measured from it, and the solid
/// stands on them. `given` where none is found, with its stroke as a text keeps it.
///
/// For several numbers of points the evenly spaced ones whose spine is nearest are found by least squares (line_fit.h).
/// On each of several grids they are then placed one after the other, so that most are where a text expects them and
/// the spine stays near (a beam search). Of the results the cheapest one with what stands besides is taken.
StrokeAndSpine shortStroke(const StrokeAndSpine& given, image::Size picture, const ribs::SpineParams& params,
                           const CostBesides& besides);

}  // namespace spineloft::publish
