// From dense lines to curves through few points, and back. Internal to sections/.
#pragma once

#include "engine/sections/drawing.h"
#include "engine/sections/symmetry.h"

namespace spineloft::sections {

/// How a chain becomes a curve.
struct FitParams {
  double tolerance = kFitTolerance;  ///< section units
  double cornerWindow = 0.09;        ///< way before and after a place over which it turns
  double cornerAngle = 0.9;          ///< radians; sharper turns are corners
  int smoothing = 0;                 ///< passes of (1 2 1)/4 between corners
};

/// A curve near the chain that repeats itself as the chain does. ≥ 3 points in the chain. Of an open one both ends are
/// corners, where openStretchOf leaves the curve straight.
DrawnCurve fitCurve(const Chain& chain, const FitParams& params);

}  // namespace spineloft::sections
