// How strong the edge under every end of a side is, compared with those near by. Where the outline is missing, a
// halo, shading or a neighbour's faint edge is left, and an end there is worth less than one on the outline.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/ribs/evidence/evidence.h"
#include "engine/ribs/field/curves.h"

namespace spineloft::ribs {

/// The ends of one side: `labels` has an entry for every rib, each a label of its curve.
struct SideEnds {
  const GradientCurves& curves;
  const std::vector<int>& labels;
  bool left = true;
};

/// Memory of edgeStrengths, and its result.
struct EdgeStrengths {
  std::vector<float> relative;     ///< of every rib's end, 0…1
  std::vector<float> raw, nearby;  ///< Lab units
};

/// The colour difference across the level set at every end (the largest within two labels of it, over the
/// contrast's reach), as a share of what a strong end near by has: three fifths of the upper quartile among
/// the ribs up to a fifth of the spine to either side. From there on it is 1. Faint as a whole, a stretch is
/// measured against itself. `differences` are those that contourContrast left in its memory, for the same
/// curves; with none everything is 1.
const std::vector<float>& edgeStrengths(const SideEnds& ends, std::span<const std::array<float, 4>> differences,
                                        EdgeStrengths& memory);

}  // namespace spineloft::ribs
