// Cutting a thing out of a picture, from a hint or two where it is.
#pragma once

#include <optional>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/vec.h"
#include "engine/image/image.h"

namespace spineloft::vision {

/// Hints in original picture pixels; at least one point inside, or a box.
struct CutHints {
  std::vector<PicturePoint> inside;   ///< points that certainly lie on the thing
  std::vector<PicturePoint> outside;  ///< points that certainly do not
  struct Box {
    PicturePoint low, high;
  };
  std::optional<Box> box;  ///< around the thing; nothing of it lies beyond
};

/// Outlines of the thing (original pixels; holes within outer ones, by even-odd), smoothed to less than
/// a working pixel, by GrabCut (Rother, Kolmogorov and Blake 2004) on a copy of at most kCutSide pixels;
/// of what it finds the pieces that hold a point of `inside`, or the largest one. The same hints always
/// give the same outlines. Errors: PictureEmpty, ValueOutOfRange (no hint, or not on the picture),
/// NothingCutOut, OutOfMemory.
Result<std::vector<std::vector<PicturePoint>>> cutOut(const image::Picture& picture,
                                                      const CutHints& hints);

inline constexpr int kCutSide = 288;

}  // namespace spineloft::vision
