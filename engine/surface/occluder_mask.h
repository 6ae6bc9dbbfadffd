// What stands before a part and reaches over it from outside, across a stretch of its outline that could
// not be seen for it: a thumb, a mug.
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
  const image::Mask& reach;      ///< where an intruder is looked for: all across the part, there and a little further
};

/// 255 where an intruder is: what can be reached from beside the stretch over colours that are common there
/// but not around the part elsewhere nor of the part; and within reach over such as the part has nowhere else,
/// gaps closed. Empty when there is none: the threshold is mostly the part's or the ground's, what was found
/// has colours of the part after all, or it hides more than a third of it. Linear.
image::Mask occluderMask(const OccludedStretch& entrance);

}  // namespace spineloft::surface
