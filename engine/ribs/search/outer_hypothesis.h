// Whether the object goes on beyond the part that was found. A highlight, a stripe or a neighbour's edge beside the
// stroke can make a narrow part that costs less than the true outline, above all where half of that is missing. Whole
// parts are compared here, by measures that no single rib has.
#pragma once

#include "engine/ribs/evidence/evidence.h"
#include "engine/ribs/field/curves.h"
#include "engine/ribs/labels/rib_lengths.h"

namespace spineloft::ribs {

/// How far the colours inside (up to 93 % of every length) differ from those in a ring outside (107 % to 160 % and
/// four map pixels more): 1 minus the Bhattacharyya coefficient of their shares of Lab cells, over all ribs; 0
/// (equal) … 1 (nothing in common). If the object goes on beyond the ends, its own colours are in the ring. Ignored
/// entries do not count; 0 where either side is empty. `colours` are sorted (sortColours), `ends` has labels of every
/// rib.
double coloursApart(const GradientCurves& curves, const UnwrappedImage& strip, const ColourTables& colours,
                    const LengthLabels& ends);

/// Mean change of the step from one rib's length to the next, both sides together, as a share of the mean
/// length: 0 for a steady taper. `ends` has labels of every rib, ≥ 1 rib.
double unevenness(const GradientCurves& curves, const LengthLabels& ends);

}  // namespace spineloft::ribs
