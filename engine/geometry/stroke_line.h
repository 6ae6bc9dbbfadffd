// From the stroke of a hand to an even, smooth line: what spines and the lines of poses share.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/base/vec.h"

namespace spineloft::geometry {

/// Points on which a stroke is worked on, whatever its own density.
inline constexpr std::size_t kStrokePoints = 512;

/// Whether a stroke reads smaller forwards than backwards: the direction in which it is worked on, so
/// that a stroke and its reverse go through the very same arithmetic. An empty one does.
bool readsForwards(std::span<const PicturePoint> stroke);

/// The same line on kStrokePoints points at even distances; ≥ 2 points, of some length.
std::vector<PicturePoint> evenStroke(std::span<const PicturePoint> stroke);

/// Smooths out what wobbles on less than `share` of the length, 0…0.2; `line` is one of evenStroke.
std::vector<PicturePoint> withoutWobble(std::span<const PicturePoint> line, double share);

}  // namespace spineloft::geometry
