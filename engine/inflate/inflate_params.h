// What a person chooses about a puff: an inflated region.
#pragma once

#include <cstdint>

namespace spineloft::inflate {

enum class InflateSides : std::uint8_t {
  Both,   ///< the same to the viewer and away
  Front,  ///< to the viewer; flat at the picture's plane
  Back,   ///< away from the viewer; flat at the picture's plane
  kCount
};

struct InflateParams {
  double height = 1;  ///< 1: a circle becomes a ball; kLeastHeight … kMostHeight
  InflateSides sides = InflateSides::Both;
  int points = 2000;  ///< about so many corners of the mesh; kLeastPoints … kMostPoints
  bool operator==(const InflateParams&) const = default;
};

inline constexpr double kLeastHeight = 0.05, kMostHeight = 4;
inline constexpr int kLeastPoints = 200, kMostPoints = 16000;

/// Everything in range and finite.
inline bool isValid(const InflateParams& p) {
  return p.height >= kLeastHeight && p.height <= kMostHeight && p.sides < InflateSides::kCount &&
         p.points >= kLeastPoints && p.points <= kMostPoints;
}

}  // namespace spineloft::inflate
