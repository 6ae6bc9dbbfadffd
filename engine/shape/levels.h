// Where the sections of a shape stand. Internal to shape/.
#pragma once

#include <optional>
#include <vector>

#include "engine/base/result.h"
#include "engine/shape/shape.h"
#include "engine/shape/side_lines.h"

namespace spineloft::shape {

/// A place in the part's picture, and two unit vectors of it, square to each other: `aside` is to the right of the way
/// along the axis as the viewer sees it. x of a SectionPoint is measured along `aside`, y along `along`, pixels.
struct AxisFrame {
  PicturePoint from, along, aside;
  SectionPoint in(PicturePoint p) const { return {dot(p - from, aside), dot(p - from, along)}; }
  PicturePoint out(SectionPoint p) const { return from + aside * p.x + along * p.y; }
};

/// A section of the shape: its four points. x of `low` and `high` is across the axis, x of `back` and `front` is z;
/// y is the place along the axis.
struct Level {
  SectionPoint low, high, back, front;
  double place = 0;  ///< along the axis, in between
  double halfWidth() const { return (high.x - low.x) / 2; }
  double halfDepth() const { return (front.x - back.x) / 2; }
};

/// All of a shape but its surface.
struct Levels {
  AxisFrame frame;
  std::vector<Level> all;                 ///< at least kLeastLevels, from start to end
  bool startTip = false, endTip = false;  ///< the first, the last one has neither width nor depth
  double size = 0;                        ///< the larger of length and width, pixels
  sections::SectionShape section;
};

/// Errors: those of makeShape.
Result<Levels> levelsOf(const ShapeParams& params, std::span<const SeenOutline> outlines);

}  // namespace spineloft::shape
