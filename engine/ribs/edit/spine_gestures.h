// What a hand does to a spine: strokes to strokes. Picture pixels; places are shares of the length.
#pragma once

#include <span>
#include <vector>

#include "engine/base/vec.h"

namespace spineloft::ribs {

/// The point at `at` goes to `to`; points within `reach` (share of the length) follow softly, others
/// stay; the ends stay unless they lie within reach. ≥ 2 points in, as many or more (evenly resampled)
/// out. at = 0 or 1 with a small reach pulls an end.
std::vector<PicturePoint> bendStroke(std::span<const PicturePoint> stroke, double at, PicturePoint to, double reach);

/// All points moved by the same.
std::vector<PicturePoint> shiftStroke(std::span<const PicturePoint> stroke, PicturePoint by);

/// The start (or end) is drawn out to `to`, or the stroke is cut where it comes nearest to `to` when
/// `to` lies back along it. The rest stays as it is. At least two points remain.
std::vector<PicturePoint> extendStroke(std::span<const PicturePoint> stroke, bool atStart, PicturePoint to);

}  // namespace spineloft::ribs
