// Regions of the plane: outlines as hands draw them, made simple, and sampled evenly.
#pragma once

#include <span>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/vec.h"

namespace spineloft::geometry {

using Contours = std::vector<std::vector<PicturePoint>>;

/// Pixel centres are at integers: a picture spans −½ … size − ½.
struct PictureFrame {
  double width = 0, height = 0;  ///< pixels, > 0
};

/// What closed outlines enclose by even-odd, or what a pen of width `ribbon` (> 0) leaves along open
/// lines, cut off at the frame: simple outlines that do not touch each other, seen with y up outer ones
/// counter-clockwise and holes clockwise. Outlines that are simple and within the frame come back as
/// they are (without repeated points); what crosses itself is read off a grid of at most
/// kRegionCells cells by its distance to the outline (marching squares, Lorensen and Cline 1987 in the
/// plane), with corners rounded by less than a cell. Pieces and holes below kLeastRegionArea go.
/// Points finite. Errors: RegionEmpty, RegionTooFine.
Result<Contours> cleanRegion(const Contours& drawn, double ribbon, PictureFrame frame);

inline constexpr double kLeastRegionArea = 12;  ///< square pixels: less is a slip of the hand
inline constexpr std::size_t kRegionCells = 200000;
inline constexpr std::size_t kMostCleanPoints = 20000;

/// Outlines with a point about every `spacing` pixels, even between corners, which stay; finer where
/// that would make outlines touch. `contours` as cleanRegion gives them; the result is of the same
/// kind. A hole or piece keeps at least 8 points.
Contours sampleRegion(const Contours& contours, double spacing);

/// Square pixels; holes count negative.
double areaOf(const Contours& contours);

/// Pixels, of all outlines, each closed.
double perimeterOf(const Contours& contours);

/// The same with y up, all outlines one after the other, and their sizes: as triangulate wants them.
struct PlaneRegion {
  std::vector<SectionPoint> points;
  std::vector<std::size_t> sizes;
};
PlaneRegion planeRegion(const Contours& contours);

}  // namespace spineloft::geometry
