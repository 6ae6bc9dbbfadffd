// Where one curve becomes several: its inside is cut into cells, and every cell goes on as one of them. Internal to
// stack/.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/vec.h"
#include "engine/stack/skin.h"

namespace spineloft::stack {

/// A closed curve in space whose points are vertices already, counter-clockwise about `normal`.
struct Loop {
  std::vector<ModelPoint> points;
  RingVertices vertices;
  ModelPoint normal;  ///< unit; of a branch its plane's
};

/// A stem and what it becomes. Everything runs along the stem's normal: for branches that join into a stem both are
/// reversed.
struct Joint {
  Loop stem;
  std::vector<Loop> branches;  ///< ≥ 1
  bool inwards = false;        ///< walls of holes
};

/// How a joint is made.
struct JointShape {
  double fullness = 0.35;  ///< κ of the Bézier rows, 0…0.5
  int rows = 12;           ///< between stem and branches, ≥ 1
};

/// Puts the surface between stem and branches into the skin. Both sides of a cut use the same vertices, so that the
/// surface is closed for any input; surfaces of different branches do not meet where a plane parts what they become.
void addJoint(const Joint& joint, const JointShape& shape, Skin& skin);

}  // namespace spineloft::stack
