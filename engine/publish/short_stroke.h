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

/// How long the text of a part with this stroke is.
using TextLength = std::function<std::size_t(const StrokeAndSpine&)>;

/// A stroke of few characters, as a share text keeps it (io::keptLine), that gives the same spine to within a quarter
/// of a pixel of a picture of 1024 pixels, point by point: rib ends that are fixed beside it are measured from it, and
/// the solid stands on them. `given` where none is found, with its stroke as a text keeps it.
///
/// For several numbers of points the line of even steps whose spine is nearest is found by least squares (line_fit.h).
/// On each of several grids they are then placed one after the other, so that most are where a text expects them and
/// the spine stays near (a beam search, line_on_grid.h). Of the cheapest results the one with the shortest text is
/// taken.
StrokeAndSpine shortStroke(const StrokeAndSpine& given, image::Size picture, const ribs::SpineParams& params,
                           const TextLength& lengthOf);

}  // namespace spineloft::publish
