// What drawn lines enclose: for drawings, where the thing has the colour of its paper. Internal to vision/.
#pragma once

#include <opencv2/core.hpp>

#include "engine/image/image.h"

namespace spineloft::vision {

/// Masks of a drawing's size.
struct Drawing {
  cv::Mat things;    ///< what lines enclose, to the middle of the outermost one, with all that is drawn within
  cv::Mat paper;     ///< what is round them
  bool any = false;  ///< there is a thing
};

/// Finds what lines enclose. In a picture that is no line drawing there is no thing.
///  1. Ink is darker than the paper round it, by a share of what ink is on average. The paper's lightness is a grey
///     closing (Serra 1982) of the picture's, so that slow shadows do not count.
///  2. Rooms are the basins of the distance to ink. Two are one where the way between them is wider than a share of
///     the smaller one's width: so a gap in a line is closed where it is small beside what the line surrounds.
///  3. Ink as thick as lines are belongs to the nearest room, deeper ink to the thing. What hangs together and does not
///     reach the picture's border is a thing, if it has the colour of the paper round it. Otherwise, and when it is
///     nearly the whole picture, its largest room is taken for paper: a frame, a sheet on a table.
/// O(n log n) for n pixels. Throws std::bad_alloc.
Drawing findEnclosed(const image::Image& copy);

}  // namespace spineloft::vision
