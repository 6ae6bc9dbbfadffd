// What a person chooses about a spun part: a region turned about an axis.
#pragma once

#include <cmath>

#include "engine/base/vec.h"

namespace spineloft::lathe {

struct LatheParams {
  PicturePoint axisFrom{0, 0}, axisTo{0, 100};  ///< two points of the axis, picture pixels, kLeastAxis apart or more
  double turn = 360;  ///< degrees from the picture's plane towards the viewer; kLeastTurn … kMostTurn
  int sides = 128;    ///< flat faces of a full turn, kLeastSides … kRoundSides, which is round
  double wall = 0;    ///< of open lines, share of the picture's longer side; 0 (solid) … kMostWall
  double squash = 1;  ///< extent towards the viewer, times that in the picture; kLeastSquash … kMostSquash
  bool operator==(const LatheParams&) const = default;
};

inline constexpr double kLeastAxis = 1, kFarthestAxis = 1e6;  ///< picture pixels
inline constexpr double kLeastTurn = 10, kMostTurn = 360;
inline constexpr int kLeastSides = 3, kRoundSides = 128;
inline constexpr double kMostWall = 0.2, kLeastSquash = 0.1, kMostSquash = 4;

/// Everything in range and finite.
inline bool isValid(const LatheParams& p) {
  const auto near = [](PicturePoint q) { return std::abs(q.x) <= kFarthestAxis && std::abs(q.y) <= kFarthestAxis; };
  return near(p.axisFrom) && near(p.axisTo) && distance(p.axisFrom, p.axisTo) >= kLeastAxis && p.turn >= kLeastTurn &&
         p.turn <= kMostTurn && p.sides >= kLeastSides && p.sides <= kRoundSides && p.wall >= 0 &&
         p.wall <= kMostWall && p.squash >= kLeastSquash && p.squash <= kMostSquash;
}

}  // namespace spineloft::lathe
