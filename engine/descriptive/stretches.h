// Outlines cut where they cross others. Internal to descriptive/.
#pragma once

#include "engine/descriptive/orders.h"

namespace spineloft::descriptive {

/// All stretches of the outlines, with type, cover and overlaps; `index` is not set. A stretch that changes its type
/// away from crossings is cut there. Shorter ones than kLeastStretch of the size are left out.
std::vector<OrderedStretch> stretchesOf(std::span<const Sheet> sheets, const Overlaps& overlaps, double size);

/// The place along an outline, pixels from its first point.
PicturePoint alongOutline(const OutlinePath& outline, double s);

inline constexpr double kLeastStretch = 0.012;
inline constexpr double kAtEdge = 0.004;  ///< nearer to a piece's edge than this it is neither in it nor outside

}  // namespace spineloft::descriptive
