// How deep the straight stretches of flat and round pieces lie, from right angles between them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/descriptive/overlaps.h"

namespace spineloft::descriptive {

/// Of two places of a piece's outline the second is nearer to the viewer than the first by `nearer`; pixels.
struct Rise {
  std::uint32_t piece = 0;
  PicturePoint from, to;
  double nearer = 0;
};

/// What right angles say of a drawing.
struct RightAngles {
  std::vector<Rise> rises;
  std::optional<ModelPoint> up;  ///< of length 1, along the most upright axis; none where there are no axes
};

/// Rises along all straight stretches, each ≥ kLeastStretch long between corners of an outline, that go along three
/// axes at right angles (axes.h). Two of the axes are those of a parallelogram, an outline with two stretches along
/// either and none along the third; of several triples the one with the longest stretches counts. An outline with
/// stretches along all three has no rises, since none of them is nearly plane. One with stretches along a single axis
/// does not turn round it: its sides are level with each other. Seen from above, what is higher
/// along the most upright axis is nearer, from below what is lower; what is upright in the picture goes up in both.
/// Empty where there are no such axes, or where it is unknown from where they are seen. `size`: sizeOf.
RightAngles rightAnglesOf(std::span<const Sheet> sheets, std::span<const Piece> pieces, double size,
                          SeenFrom seenFrom = SeenFrom::Above);

inline constexpr double kLeastStretch = 0.1;  ///< a share of the size

}  // namespace spineloft::descriptive
