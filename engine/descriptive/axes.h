// Directions of straight edges in a picture, and which three are those of a right-angled corner.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/vec.h"

namespace spineloft::descriptive {

/// Edges of almost one direction, y up.
struct Direction {
  SectionPoint unit;
  double angle = 0;   ///< 0…π
  double length = 0;  ///< of all of them
};
struct Directions {
  std::vector<Direction> all;
  std::vector<std::size_t> of;  ///< by edge
};

/// Clusters edges, given from end to end, by their direction: the two nearest clusters become one while they are nearer
/// than kOneDirection. Cost: edges squared.
Directions directionsOf(std::span<const SectionPoint> ways);

inline constexpr std::size_t kNoAxis = 3;

/// Three directions u₁, u₂, u₃ that can be those of a right-angled corner, A₁₂A₁₃A₂₃ > 0 with A_ij = −u_i·u_j, and dz
/// per length along each: s₁ = √(A₁₂A₁₃/A₂₃), s₂ = A₁₂/s₁, s₃ = A₁₃/s₁; all three with the other sign look alike.
struct Axes {
  std::array<std::size_t, 3> direction{};
  std::array<double, 3> slope{};
  /// Which axis a direction is, or kNoAxis.
  std::size_t of(std::size_t d) const {
    return static_cast<std::size_t>(std::ranges::find(direction, d) - direction.begin());
  }
};

/// The three with the highest score, > 0; of equal ones those that are farthest apart. None where no three qualify.
std::optional<Axes> bestAxes(std::span<const Direction> directions, const std::function<double(const Axes&)>& score);

inline constexpr double kOneDirection = 0.157;  ///< 9°
/// A longer dz per length is a direction towards the eye, which the picture does not show.
inline constexpr double kMostSlope = 12;

}  // namespace spineloft::descriptive
