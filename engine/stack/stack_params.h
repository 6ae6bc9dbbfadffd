// What a person draws for a stack: closed curves of true size on planes in space, and the rail that planes stand on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/vec.h"
#include "engine/geometry/turn.h"
#include "engine/sections/blend.h"
#include "engine/sections/drawing.h"
#include "engine/sections/ends.h"

namespace spineloft::stack {

/// Which points of a curve are corners: the curve turns sharply there, and is straight between two of them.
struct Corners {
  bool all = false;
  std::vector<std::uint32_t> at;  ///< else: indices of points
  bool operator==(const Corners&) const = default;
};

/// A closed curve through a few points, as sections::DrawnCurve has it, of true size: plane coordinates in picture
/// pixels. Curves within curves of a plane are holes (even-odd).
struct Curve {
  std::vector<SectionPoint> through;
  Corners corners;
  bool operator==(const Curve&) const = default;
};

/// A plane in space with the curves on it. On the rail its origin is the rail's point, x runs to the right of the way
/// along the rail as seen from the viewer, y to the viewer, and `turn` turns it from there. Off the rail its origin is
/// `origin`, x, y and the normal are those of ModelSpace, turned.
struct Plane {
  double at = 0;                     ///< on the rail: share of its length, 0…1
  std::optional<ModelPoint> origin;  ///< off the rail
  geometry::Turn turn;
  std::vector<Curve> curves;
  sections::Blend blend{sections::BlendKind::Flow, {}};  ///< from here to the next plane
  bool operator==(const Plane&) const = default;
};

/// The line that planes stand on: cubic arcs through its points, a circle where they lie on one. Without points there
/// is none.
struct Rail {
  std::vector<ModelPoint> points;
  bool closed = false;
  bool operator==(const Rail&) const = default;
};

struct StackParams {
  sections::CapStyle startCap = sections::CapStyle::Flat, endCap = sections::CapStyle::Flat;
  int sides = 128;   ///< points round a curve, kLeastSides…kMostSides
  int capRings = 6;  ///< of round ends
  bool operator==(const StackParams&) const = default;
};

inline constexpr std::size_t kMostPlanes = 64, kMostCurves = sections::kMostContours,
                             kMostThrough = sections::kMostDrawnPoints, kMostRailPoints = 256,
                             kMostPoints = 50000;  ///< of all curves
inline constexpr double kFarOut = 1e5;             ///< of any coordinate, picture pixels
inline constexpr int kLeastSides = 12, kMostSides = 256, kMostCapRings = 32;

/// In range.
bool isValid(const StackParams& params);
bool isValid(const Rail& rail);
bool isValid(const Curve& curve);
/// Numbers finite and in range, not too many; whether the curves make sections is only known when they are stacked.
bool isValid(const Plane& plane);
/// At least one plane with a curve. Error: StackInvalid with what is missing.
Status checkPlanes(const std::vector<Plane>& planes, const Rail& rail);

}  // namespace spineloft::stack
