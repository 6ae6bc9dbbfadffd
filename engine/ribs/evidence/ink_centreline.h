// Where a rib end stands when the outline is drawn: in the middle of the ink.
#pragma once

#include "engine/image/edge_map.h"
#include "engine/ribs/field/curves.h"

namespace spineloft::ribs {

/// The middle of the pen line on or beside which the place `along` of a curve lies; `along` itself
/// where there is no such line. Both are arc lengths from the spine, picture pixels.
///
/// A pen line is a narrow stretch of one colour between two stretches of another that are alike, as paper is on both
/// sides of ink; the edge between an object and its background is no such line. It is at most about a hundredth of
/// the longer side of the map broad, and narrow against `along`; broader ink belongs to the object. The two edges of
/// a line thus count once, and its breadth does not widen the object. `edges` is not empty; the curve has its point
/// `along`.
double middleOfLine(const GradientCurves& curves, const image::EdgeMap& edges, int curve, double along);

}  // namespace spineloft::ribs
