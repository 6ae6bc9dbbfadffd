// Colours of a thing, without those of what is around it: kept well inside its outline and carried from
// there over the rim and beyond.
#pragma once

#include "engine/image/image.h"

namespace spineloft::surface {

/// How far the colours of an outline's pixels are mixed with those behind: pixels nearer than this to
/// the outline are not trusted. In pixels of a picture whose longer side is `longSide`: 2 for small
/// pictures, more where the same blur covers more pixels.
double rimMargin(int longSide);

/// The part of `mask` (255 inside) that is more than `margin` pixels (0…64) from every pixel outside. Same
/// size. Beyond the mask's border nothing counts as outside: a picture cuts things off there.
image::Mask inset(const image::Mask& mask, double margin);

/// The part of `covered` (255 inside) whose pixels are trusted: at least `margin` pixels (≥ 0, at most
/// 64) from the nearest pixel outside, or half as far as the thing is wide there where it is too thin
/// for that, so that no piece of it loses all of its colours. As inset otherwise.
image::Mask trusted(const image::Mask& covered, double margin);

/// `image` with every pixel that is not in `known` (255; same size), or is mostly transparent, filled
/// from the nearest known ones: averages over ever larger neighbourhoods (push and pull: Gortler and
/// others, The Lumigraph, 1996, section 3.4). All pixels are opaque afterwards; known ones keep
/// their colour. Empty when the sizes differ or nothing is known. Linear.
image::Image bleed(const image::Image& image, const image::Mask& known);

}  // namespace spineloft::surface
