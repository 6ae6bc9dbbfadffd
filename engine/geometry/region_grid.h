// Outlines read off a grid of distances of at most kRegionCells cells: what untangles drawings, and walls.
#pragma once

#include "engine/geometry/region.h"

namespace spineloft::geometry {

/// What the closed outlines enclose by even-odd within the frame.
Contours evenOddOutlines(const Contours& contours, PictureFrame frame);
/// What lies within half of `width` of the open lines, and within the frame.
Contours ribbonOutlines(const Contours& lines, double width, PictureFrame frame);

/// A wall along the inside of outlines.
struct Wall {
  const Contours& outlines;  ///< closed
  const Contours& lines;     ///< open, along the outlines
  double thickness = 0;      ///< > 0; at least three cells are taken
  /// Where it ends: on the line, and the direction in which it goes on. There it is rounded by half its thickness.
  struct End {
    PicturePoint at, outwards;
  };
  std::span<const End> ends;
};
/// What the outlines enclose by even-odd within the thickness of the lines. Empty when that leaves nothing free.
Contours wallOutlines(const Wall& wall, PictureFrame frame);

}  // namespace spineloft::geometry
