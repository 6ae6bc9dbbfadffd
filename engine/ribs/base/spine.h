// The spine: from the stroke of a hand to an even, smooth polyline (method: "Gradient curves";
// SpineLoft 3.3.1).
#pragma once

#include <span>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/vec.h"
#include "engine/geometry/stroke_line.h"
#include "engine/image/image.h"

namespace spineloft::ribs {

/// A cleaned spine: evenly spaced, smooth, without self-crossings, inside the picture; ≥ 2 points
/// in picture pixels, in drawing order.
struct Spine {
  std::vector<PicturePoint> points;
  bool operator==(const Spine&) const = default;
};

struct SpineParams {
  int ribs = 100;  ///< number of spine points, hence of ribs, 2…800
  /// Fewer points are used when they would be closer than this, picture pixels, 0.1…100.
  double minSpacing = 2.0;
  /// Wobble shorter than this share of the length is smoothed out, 0…0.2.
  double smoothness = 0.1;
  bool operator==(const SpineParams&) const = default;
};

/// Cleans a stroke: drops repeats, clips what leaves the picture (the longest inside run stays),
/// removes a short self-crossing hook at an end, resamples, smooths.
/// Independent (within a pixel) of how densely the stroke was sampled; drawing it backwards
/// reverses the result exactly. Errors: StrokeNotFinite, StrokeTooShort, StrokeOutsidePicture,
/// StrokeLoops, ValueOutOfRange.
Result<Spine> cleanSpine(std::span<const PicturePoint> stroke, image::Size picture, const SpineParams& params);

/// What a stroke is cleaned in: reused from stroke to stroke, without a trace in any result.
struct SpineMemory {
  geometry::StrokeMemory line;
  std::vector<PicturePoint> points, run;
};
/// The same into `spine`, in place of what it held, without asking for memory once both have seen strokes of as
/// many points. After a failure `spine` is of no use.
Status cleanSpine(std::span<const PicturePoint> stroke, image::Size picture, const SpineParams& params,
                  SpineMemory& memory, Spine& spine);

}  // namespace spineloft::ribs
