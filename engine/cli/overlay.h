// A picture to look at: what was found, drawn over the darkened picture.
#pragma once

#include <span>

#include "engine/base/vec.h"
#include "engine/cli/score.h"
#include "engine/image/image.h"
#include "engine/ribs/base/rib_set.h"

namespace spineloft::cli {

struct OverlayInput {
  const image::Picture& picture;
  const ribs::RibSet& ribs;
  const image::Mask& part;   ///< silhouette, as large as the picture
  const image::Mask& truth;  ///< as large as the picture; above 200 is the part
  std::span<const PicturePoint> stroke;
};

/// The working copy at a third of its brightness; the stroke white; each half rib green (edge),
/// orange (bridged) or red (guessed); the part's outline yellow and the true outline cyan.
image::Image drawOverlay(const OverlayInput& input);

}  // namespace spineloft::cli
