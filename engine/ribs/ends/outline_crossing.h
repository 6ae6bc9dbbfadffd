// How far the curves of one stroke lie within the part that another one found. Internal to ribs/.
#pragma once

#include <vector>

#include "engine/ribs/base/rib_set.h"
#include "engine/ribs/field/curves.h"

namespace spineloft::ribs {

/// The outline of a part: left ends, the end's fan, right ends backwards, the start's fan. Picture pixels.
std::vector<PicturePoint> outlineOf(const RibSet& part);

/// Of every curve the arc length (picture pixels) at which it first leaves a closed outline: 0 where the
/// curve begins outside (nonzero winding), its whole length where it never leaves. O(curves · outline), of which few
/// pairs meet.
std::vector<float> lengthsWithin(const std::vector<PicturePoint>& outline, const GradientCurves& curves);

/// Replaces the lengths of the fans' curves (picture pixels, curves in order round the part) by medians of five
/// neighbours: where the ensemble is divided about an end, single curves would stand out. Lengths of ribs stay.
std::vector<float> withoutSpikes(const std::vector<float>& lengths, const CurveLayout& layout);

}  // namespace spineloft::ribs
