// A stroke drawn past the ends of a thing, as hands in a hurry do: what is left of the accuracy then.
#pragma once

#include <span>
#include <vector>

#include "engine/base/vec.h"
#include "engine/cli/score.h"

namespace spineloft::accuracy {

/// The stroke gone on straight at either end until it is `share` (0…3) of half the local width beyond the
/// true part, as far as the picture goes. An end at which the part goes on into something else is left
/// where it is. 0 changes nothing. `stroke`: ≥ 2 points, picture pixels.
std::vector<PicturePoint> overshot(const cli::Truth& truth, std::span<const PicturePoint> stroke, double share);

}  // namespace spineloft::accuracy
