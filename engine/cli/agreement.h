// How much it matters which of several strokes was drawn through one thing.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/vec.h"
#include "engine/cli/score.h"
#include "engine/image/image.h"

namespace spineloft::cli {

/// Mean IoU of all pairs of parts of one case: 1 where it does not matter which stroke was drawn.
struct Agreement {
  double whole = 1;  ///< over all pixels
  double body = 1;   ///< over pixels between the innermost ends of all strokes that are not do-not-care
};

/// `parts` are the strokes' silhouettes (every value > 0 is the part), of the case's size, or empty for no part: that
/// one has nothing in common with any. `strokes` are named, ≥ 2 points each, picture pixels. One part agrees with
/// itself.
Agreement agreementOf(const Truth& truth, std::span<const image::Mask> parts,
                      std::span<const std::pair<std::string, std::vector<PicturePoint>>> strokes);

}  // namespace spineloft::cli
