// What lies within the outline of a part in its picture but does not belong to it: background where the outline
// reaches too far, occluders, and the mixed colours of the rim.
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

/// Distance (px) around a part within which no colours of the background are learned, because the part may go on
/// there: a share of half its width, at most 64. `depth`: mean distance of its pixels from its outline.
double clearanceOf(double depth);

/// 0 at covered pixels that are background, 255 at the other covered ones, arbitrary elsewhere. A front moves inwards
/// from beyond the clearance (px, 0…64); each of its pixels keeps about the colour with which it started. Within the
/// part it goes on only over pixels that are not sure, are more common around the part than in it, and differ from
/// the colours expected of the part there. What it reaches is background. Linear.
image::Mask ownPixels(const Doubt& doubt, double clearance);

/// `kept`, and those pixels of `rim` (both of the size of the image) that have a colour of the part alone: not
/// between `in` and `out` by more than a little, or where the two are so alike that it makes no difference. `in` and
/// `out`: the colours of the part and of the background, extended (edge_padding.h).
image::Mask withCleanRim(const image::Image& shown, const image::Mask& kept, const image::Mask& rim,
                         const ColourPyramid& in, const ColourPyramid& out);

}  // namespace spineloft::surface
