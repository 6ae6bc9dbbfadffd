// Outlines read off a grid of distances: what untangles drawings. Internal to geometry/.
#pragma once

#include "engine/geometry/region.h"

namespace spineloft::geometry {

/// What the closed outlines enclose by even-odd within the frame.
Contours evenOddOutlines(const Contours& contours, PictureFrame frame);
/// What lies within half of `width` of the open lines, and within the frame.
Contours ribbonOutlines(const Contours& lines, double width, PictureFrame frame);

}  // namespace spineloft::geometry
