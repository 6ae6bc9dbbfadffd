// How deep the straight stretches of flat and round pieces lie, from right angles between them.
#pragma once

#include <cstdint>
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

/// Rises along all straight stretches, each ≥ kLeastStretch long between corners of an outline, that go along three
/// axes at right angles (axes.h). Two of the axes are those of a parallelogram, an outline with two stretches along
/// either and none along the third; of several triples the one with the longest stretches counts. An outline with
/// stretches along all three has no rises, since none of them is nearly plane. One with stretches along a single axis
/// does not turn round it: its sides are level with each other. What is drawn is seen from above: along the most
/// upright axis what is higher is nearer. Empty where there are no such axes. `size`: sizeOf.
std::vector<Rise> risesOf(std::span<const Sheet> sheets, std::span<const Piece> pieces, double size);

inline constexpr double kLeastStretch = 0.1;  ///< a share of the size

}  // namespace spineloft::descriptive
