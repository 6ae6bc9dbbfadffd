// A line on a grid that takes few characters. Internal to publish/.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/base/vec.h"
#include "engine/publish/line_fit.h"

namespace spineloft::publish {

struct LineGrid {
  double step = 1;       ///< of the points of the line
  double tolerance = 1;  ///< no point of the spine gets farther off, as LineFit foretells it
  double rough = 1;  ///< a step of the spine that is off by this takes a quarter of a bit: ribs change their direction
};

/// A line on a grid.
struct GridLine {
  std::vector<PicturePoint> points;
  double cost =
      0;  ///< of its numbers, and about what the rib ends cost more because its spine is off, quarters of a bit
};

/// The points of the fit, moved by a few steps to places on the grid where most numbers are as io::EvenLine with this
/// bend expects them. None where a point has no place. Cost: a few ten thousand products a point.
std::optional<GridLine> lineOnGrid(const LineFit& fit, const LineGrid& grid, std::int64_t bend);

}  // namespace spineloft::publish
