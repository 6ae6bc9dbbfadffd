// Where two stretches of lines cross. Internal to inflate/.
#pragma once

#include <algorithm>
#include <optional>

#include "engine/base/vec.h"

namespace spineloft::inflate {

/// Where on a, b it meets c, d inside of both: the share of a, b.
inline std::optional<double> crossing(SectionPoint a, SectionPoint b, SectionPoint c, SectionPoint d) {
  if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
      std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y))
    return std::nullopt;
  const double turn = cross(b - a, d - c);
  if (turn == 0) return std::nullopt;
  const double t = cross(c - a, d - c) / turn, u = cross(c - a, b - a) / turn;
  constexpr double kEnd = 1e-9;
  if (t < kEnd || t > 1 - kEnd || u < kEnd || u > 1 - kEnd) return std::nullopt;
  return t;
}

}  // namespace spineloft::inflate
