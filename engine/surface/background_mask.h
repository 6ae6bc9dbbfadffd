// What lies within the outline of a part in its picture and is not the part: the ground where the
// outline reaches too far, things that stand before it, and the mixed colours of the rim.
#pragma once

#include "engine/image/image.h"
#include "engine/surface/edge_padding.h"

namespace spineloft::surface {

/// A part in a picture. All of one size; masks are 255 inside.
struct Doubt {
  const image::Image& shown;
  const image::Mask& covered;  ///< by the part
  const image::Mask& sure;     ///< where nothing else can be
  const image::Mask& own;      ///< the part's certainly: its colours are learnt here
  const ColourPyramid& in;     ///< its colours
};

/// How far around a part (px) nothing is learnt of what it stands before, because it may well go on
/// there: a share of half its width, at most 64. `depth`: mean distance of its pixels from its
/// outline.
double clearanceOf(double depth);

/// 0 at covered pixels that are foreign, 255 at the other covered ones and arbitrary elsewhere.
/// From beyond the clearance (px, 0…64) a front moves inwards, each of its pixels in about the
/// colour that it set out with; in the part it goes on over what is not sure, is more common around
/// the part than in it, and unlike what the part should show there. What it reaches is foreign, all
/// else is believed. Linear.
image::Mask ownPixels(const Doubt& doubt, double clearance);

/// `kept` and those of the pixels of `rim` (both of the image's size) whose colour is that of the
/// part alone: not on its way from `in` to `out` by more than a little, or where the two are so
/// alike that it does not matter. `in` and `out`: the colours of the part and of what is behind it,
/// carried on.
image::Mask withCleanRim(const image::Image& shown, const image::Mask& kept, const image::Mask& rim,
                         const ColourPyramid& in, const ColourPyramid& out);

}  // namespace spineloft::surface
