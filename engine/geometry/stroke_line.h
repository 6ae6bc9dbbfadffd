// From the stroke of a hand to an even, smooth line: what spines and the lines of poses share.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/base/vec.h"
#include "engine/geometry/polyline.h"

namespace spineloft::geometry {

/// Points on which a stroke is worked on, whatever its own density.
inline constexpr std::size_t kStrokePoints = 512;

/// Whether a stroke reads smaller forwards than backwards: the direction in which it is worked on, so
/// that a stroke and its reverse go through the very same arithmetic. An empty one does.
bool readsForwards(std::span<const PicturePoint> stroke);

/// What a stroke is worked on in: reused from stroke to stroke, without a trace in any result.
struct StrokeMemory {
  std::vector<double> lengths;
  std::vector<PicturePoint> spare;
  SmoothMemory smooth;
};

/// The same line on `count` points at even distances; `line` has ≥ 2 points, of some length.
void spreadEvenly(std::vector<PicturePoint>& line, std::size_t count, StrokeMemory& memory);

/// Smooths out what wobbles on less than `share` of the length, 0…0.2; `line` is spread evenly over kStrokePoints.
void smoothWobble(std::vector<PicturePoint>& line, double share, StrokeMemory& memory);

/// Length of a line of ≥ 1 point.
double lengthOf(std::span<const PicturePoint> line);

}  // namespace spineloft::geometry
