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
  double angle = 0;       ///< 0…π
  double length = 0;      ///< of all of them
  double logLengths = 0;  ///< the sum of ln length, of `edges` of them
  double edges = 0;
};
struct Directions {
  std::vector<Direction> all;
  std::vector<std::size_t> of;  ///< by edge
};

/// Clusters edges, given from end to end, by their direction: the two nearest clusters become one while they are nearer
/// than kOneDirection and no edge of one meets an edge of the other at a corner (`meet`, symmetric). Cost: edges cubed.
Directions directionsOf(std::span<const SectionPoint> ways, const std::function<bool(std::size_t, std::size_t)>& meet);

inline constexpr std::size_t kNoAxis = 3;

/// Three directions in the picture that are those of a right-angled corner, and dz per length along each. Directions
/// u₁, u₂, u₃ can be that if A₁₂A₁₃A₂₃ > 0, A_ij = −u_i·u_j; then s₁ = √(A₁₂A₁₃/A₂₃), s₂ = A₁₂/s₁, s₃ = A₁₃/s₁, and all
/// three with the other sign look alike. The nearer two of them are to a right angle in the picture, the more a degree
/// changes how deep the third goes. So the directions are turned by the angles δ for which
/// Σ (δ_k/kTurned)² + Σ ((e_k − mean e)/kUneven)² is least, e_k = ln(L_k/E_k): L_k = l_k √(1 + s_k²) is how long the
/// edges along k are in space, l_k the geometric mean of what is drawn, E_k what is expected: all alike. A drawing with
/// two directions at a right angle − kFrontal or more is an oblique projection: no view from afar looks like it. Its
/// front is as it is drawn, E = l, and its third edges, drawn in full (cavalier) or at half (cabinet), have that E_3 of
/// l_3 to 2 l_3 that is nearest to √(l_1 l_2); kUnevenOblique is in the place of kUneven.
struct Axes {
  std::array<std::size_t, 3> direction{};
  std::array<double, 3> slope{};
  std::array<SectionPoint, 3> unit{};  ///< as turned
  /// Which axis a direction is, or kNoAxis.
  std::size_t of(std::size_t d) const {
    return static_cast<std::size_t>(std::ranges::find(direction, d) - direction.begin());
  }
};

/// Which of three directions goes back where the other two are the front of an oblique projection; none: they are not.
std::optional<std::size_t> goingBack(const Axes& axes, std::span<const Direction> directions);

/// The three with the highest score, > 0; of equal ones those that have to turn least. None where no three qualify: one
/// would turn by kOneDirection or more.
std::optional<Axes> bestAxes(std::span<const Direction> directions, const std::function<double(const Axes&)>& score);

inline constexpr double kOneDirection = 0.157;  ///< 9°
inline constexpr double kTurned = 0.035;        ///< 2°, standard deviation of a direction as drawn
inline constexpr double kUneven = 1.4;  ///< that of ln length: edges along an axis are four times as long, or a quarter
inline constexpr double kUnevenOblique = 0.1;
inline constexpr double kFrontal = 0.052;  ///< 3°

}  // namespace spineloft::descriptive
