// The closed curves of a section as they are worked on.
#pragma once

#include <vector>

#include "engine/sections/section.h"

namespace spineloft::sections {

/// A counter-clockwise closed curve in section units, and which of its points must not be smoothed
/// away: corners, and where straight stretches meet arcs.
struct Contour {
  std::vector<SectionPoint> points;
  std::vector<bool> knot;  ///< one a point
};

/// The preset with about `count` ≥ 12 points spread evenly between its knots.
Contour presetContour(SectionPreset preset, int count);

/// A closed curve of a section and its part in it. Holes too run counter-clockwise here.
struct SectionPiece {
  Contour contour;
  bool hole = false;
  std::size_t outer = 0;  ///< of a hole: which of the pieces it is in
};

/// Which of pieces that run counter-clockwise, are simple and apart are holes, and of which: those in an odd number of
/// others, of the smallest round them.
void nest(std::vector<SectionPiece>& pieces);

/// The pieces of a shape, fit for work: curves run counter-clockwise, the whole touches x = −1 and
/// x = +1 (scaled evenly about the spine, and moved along x), points that repeat are dropped, and drawn
/// curves are simplified by less than kSmallest section units, so that they stay simple and apart.
/// Errors: SectionInvalid with what is wrong in plain words.
Result<std::vector<SectionPiece>> readShape(const SectionShape& shape);

/// Largest deviation of the simplification, section units: invisible.
inline constexpr double kSmallest = 0.002;
/// Most points of all pieces of a shape after simplification.
inline constexpr std::size_t kMostShapePoints = 2048;
/// A drawn section reaches at most this far to the viewer and back, half widths.
inline constexpr double kDeepest = 8;

}  // namespace spineloft::sections
