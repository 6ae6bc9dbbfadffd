// The points of a stroke whose spine is nearest to a given one. Internal to publish/.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/base/vec.h"
#include "engine/ribs/base/spine.h"

namespace spineloft::publish {

/// Points of a stroke, and what their spine does when they move by little.
struct LineFit {
  std::vector<PicturePoint> points;
  /// How far the points of the spine are from the wanted ones.
  std::vector<PicturePoint> off;
  /// How each point of the spine moves while a point of the stroke moves by 1: its x at 2i, its y at 2i + 1.
  std::vector<std::vector<PicturePoint>> moves;
};

/// The largest of these distances from 0.
double farthest(const std::vector<PicturePoint>& off);

/// `count` ≥ 2 points that are evenly apart, by damped least squares in a few steps over where the line begins, the
/// length of its steps, and where each of them leads. The spine is that of ribs::cleanSpine where it has nothing to
/// mend. wanted.points: ≥ 2. Cost: about 2 · count cleanings a step, and a system of count + 2 unknowns.
LineFit fitLine(const ribs::Spine& wanted, std::size_t count, double smoothness);

}  // namespace spineloft::publish
