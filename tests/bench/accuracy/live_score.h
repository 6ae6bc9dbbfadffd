// How near what a pen shows while it moves is to what stays when it lifts.
#pragma once

#include <span>

#include "engine/base/vec.h"
#include "engine/image/edge_map.h"
#include "engine/image/image.h"
#include "engine/ribs/base/rib_params.h"

namespace spineloft::accuracy {

/// Distances between the rib ends of a live trace (live_trace.h) and those of a whole trace of the same
/// stroke, in % of the local width.
struct LiveScore {
  double upPct = 0;     ///< mean when the pen lifts
  double meanPct = 0;   ///< mean of all moments that were looked at
  double jumps = 0;     ///< share of the moments at which the mean is above 5 %: a jump that is seen
  double followed = 0;  ///< share of the moves that needed no whole trace
};

/// Draws the stroke in `moves` ≥ 10 even pieces and looks at ten moments, the last of them its end. All
/// zero where no part can be made.
LiveScore scoreLive(std::span<const PicturePoint> stroke, const image::EdgeMap& edges, image::Size size,
                    const ribs::RibParams& params, int moves);

}  // namespace spineloft::accuracy
