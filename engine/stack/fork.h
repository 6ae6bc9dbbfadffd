// Where curves become several or one of several: the inside of each that does is cut into cells, one for each curve
// that it becomes. Internal to stack/.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/base/vec.h"
#include "engine/stack/skin.h"

namespace spineloft::stack {

/// A closed curve in space whose points are vertices already, counter-clockwise about `normal`.
struct Loop {
  std::vector<ModelPoint> points;
  RingVertices vertices;
  ModelPoint normal;           ///< unit, of its plane, along the way through the stack
  std::optional<double> rise;  ///< of the cuts through it, 0…1 of the way to what it becomes; none: chosen
};

/// Curves of two sheets of which some become several of the others.
struct Joint {
  std::vector<Loop> below, above;
  std::vector<std::array<std::size_t, 2>> links;  ///< of which becomes which: below, above
  bool inwards = false;                           ///< walls of holes
};

/// A half-space: normal · (p − origin) ≤ 0.
struct HalfSpace {
  ModelPoint origin, normal;
};

/// Where a joint was cut.
struct JointCuts {
  std::vector<std::optional<double>> below, above;  ///< rise of the first one through each curve; none: it becomes one
  RingVertices crease;                              ///< the vertices of all between their ends
};

/// How a joint is made.
struct JointShape {
  double fullness = 0.35;  ///< κ of the Bézier rows, 0…0.5
  int rows = 12;           ///< between the sheets, ≥ 1
  /// Where several become several each link goes through a circle half way; here, every link of a fork does.
  bool halves = false;
  double waist = 0.45;  ///< most radius of such a circle, of the way to the next one
};

/// Puts the surface between the curves into the skin. Both sides of a cut use the same vertices, so that the surface is
/// closed for any input; surfaces of different links do not meet where a plane parts what a curve becomes.
JointCuts addJoint(const Joint& joint, const JointShape& shape, Skin& skin);

}  // namespace spineloft::stack
