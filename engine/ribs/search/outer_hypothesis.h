// Whether the thing goes on beyond the part that was found: a shine, a stripe or a neighbour's edge beside the
// stroke can make a narrow part that costs less than the thing's own outline, half of which is gone. Parts are
// compared as wholes then, by what no single rib sees.
#pragma once

#include "engine/ribs/evidence/evidence.h"
#include "engine/ribs/field/curves.h"
#include "engine/ribs/labels/rib_lengths.h"

namespace spineloft::ribs {

/// How different the colours between the spine and the ends (up to 93 % of the way) are from those in a ring
/// outside (from 107 % of the way to 160 % and four map pixels more), 0 (the same) … 1 (none in common): one less
/// the Bhattacharyya coefficient of their shares of Lab cells, all ribs together. Where the thing goes on beyond
/// the ends, its own colours lie outside. What is ignored does not count; 0 where nothing is left of either.
/// `colours` are sorted (sortColours), `ends` has labels of every rib.
double coloursApart(const GradientCurves& curves, const UnwrappedImage& strip, const ColourTables& colours,
                    const LengthLabels& ends);

/// Mean change of the step from one rib's length to the next, both sides together, as a share of the mean
/// length: 0 for a steady taper. `ends` has labels of every rib, ≥ 1 rib.
double unevenness(const GradientCurves& curves, const LengthLabels& ends);

}  // namespace spineloft::ribs
