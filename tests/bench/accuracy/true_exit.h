// Where a curve of the search leaves the true part.
#pragma once

#include "engine/image/image.h"
#include "engine/ribs/field/curves.h"

namespace spineloft::accuracy {

inline constexpr float kUnknown = -1;

/// The label at which a curve first leaves the part, to a fraction; kUnknown where it begins outside, leaves through
/// what does not count, or never leaves. `mask`: above 200 the part, 61…200 do not care, else not the part.
float trueExit(const ribs::GradientCurves& curves, int curve, const image::Mask& mask);

}  // namespace spineloft::accuracy
