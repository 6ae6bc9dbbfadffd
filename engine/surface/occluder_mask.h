// Occluders: what stands before a part and reaches over it from outside, across a stretch of the outline that it
// hides (a thumb, a mug).
#pragma once

#include "engine/image/image.h"

namespace spineloft::surface {

/// Where something may come in over a part. All of one size; masks are 255 inside.
struct OccludedStretch {
  const image::Image& shown;
  const image::Mask& covered;    ///< by the part
  const image::Mask& own;        ///< within: away from its rim, its colours are learnt here beyond `reach`
  const image::Mask& outside;    ///< beside the stretch; what of it is covered does not count
  const image::Mask& threshold;  ///< along the stretch, just within the part
  const image::Mask& reach;      ///< where an occluder is searched: across the part, there and a little further
};

/// 255 where an occluder is: what can be reached from beside the stretch over colours that are common there but
/// neither around the rest of the part nor on it; and, within `reach`, over colours that the part has nowhere else;
/// gaps closed. Empty when there is none: the threshold shows mostly the part or the background, what was found has
/// colours of the part, or it would hide more than a third of it. Linear.
image::Mask occluderMask(const OccludedStretch& entrance);

}  // namespace spineloft::surface
