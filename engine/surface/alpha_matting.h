// Alpha matting of the rim of a part. Soft rims (fur, hair, defocus): the background is removed from the mixed
// colours. Crisp rims: pixels mixed by the lens, the file or an inexact outline are marked.
#pragma once

#include <memory>

#include "engine/image/image.h"

namespace spineloft::surface {

/// How deep a soft rim may be that is looked for, pixels: a share of half a part's width, and more than its
/// crisp rim. `margin`, `clearance`: rimMargin and clearanceOf.
double softReach(double margin, double clearance);

/// Of the pixels of a region near its outline those where the colours further in and further out are alike (255):
/// nothing tells which is ground, so none is. Masks of the region's size.
struct Untold {
  image::Mask alike;
  image::Mask drawn;  ///< what of these is unlike both: the line of a drawing that the outline follows
};

/// Takes the ground out of the soft rim of a part. `region`: what is seen of the part; `inner`: what of that is
/// trusted by its distance from the rim, `margin` px (255 inside; all of one size).
///
/// Colours of the part are learnt `reach` px within, those behind it as far outside, each from its own
/// surroundings (mean and covariance). A pixel's colour is taken for a mixture p = (1 − a) F + a B of one of each;
/// a is its place on the line between the means, along Fisher's discriminant. The mean of a over a stretch of the rim
/// at the same depth is mixed in, so that a grain or a stripe is not taken for ground. A stretch is soft where a sinks
/// from the ground to nothing across the outline over three margins and more; only there and only as deep, pixels with
/// a larger than a little get the most likely F of the part's colours (Chuang and others, A Bayesian approach to
/// digital matting, 2001, eq. 9), and are trusted in `inner` from then on unless they are mostly ground. All others
/// stay as they are, to the bit. Where a stretch is not soft, `inner` loses the pixels that are less deep than its
/// mixture, two margins at most. The mixture ends where a falls no faster than further in (as the part's own shading
/// does), and at the latest as far inside the middle of the change as it began outside: a blur reaches equally far to
/// both sides. Two linear steps: learning, then changing. All arguments must outlive it.
class RimUnmixing {
 public:
  RimUnmixing(image::Image& shown, const image::Mask& region, image::Mask& inner, double margin, double reach);
  ~RimUnmixing();
  RimUnmixing(const RimUnmixing&) = delete;
  RimUnmixing& operator=(const RimUnmixing&) = delete;
  /// Once. Whether anything was changed.
  bool change();
  /// After `change`.
  Untold untold() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace spineloft::surface
