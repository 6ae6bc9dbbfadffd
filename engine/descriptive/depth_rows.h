// The inequalities between the depths of overlapping pieces. Internal to descriptive/.
#pragma once

#include "engine/descriptive/depth.h"

namespace spineloft::descriptive {

/// z_a − z_b ≥ least, which depends on the thickness of both.
struct OrderRow {
  enum class Kind : std::uint8_t {
    OuterRim,     ///< a corner of the rim of a before the front of b
    InnerRim,     ///< a corner of the rim of b behind the back of a
    Surface,      ///< front before front, back before back
    Before,       ///< an outline that goes inside later: a before the front of b
    BehindFront,  ///< the outline of b behind the front of a, in which it is
    BeforeBack,   ///< the outline of a before the back of b, in which it is
    kCount
  };
  std::uint32_t overlap = 0;
  Kind kind = Kind::Surface;
  PiecePlace a, b;
};

/// Every row that an overlap may need.
std::vector<OrderRow> orderRows(const DepthInput& input);

/// Its right side.
double leastOf(const OrderRow& row, std::span<const PieceDepth> depths);

}  // namespace spineloft::descriptive
