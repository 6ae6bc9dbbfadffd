// What a person chooses about a puff: an inflated region.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/sections/section.h"

namespace spineloft::inflate {

enum class InflateSides : std::uint8_t {
  Both,   ///< the same to the viewer and away
  Front,  ///< to the viewer; flat at the picture's plane
  Back,   ///< away from the viewer; flat at the picture's plane
  kCount
};

/// A slice of a puff, mirror-symmetric in x: from the bone at x = 0 to the outline at x = ±1.
struct ProfileSlice {
  sections::SectionShape shape;
  bool operator==(const ProfileSlice&) const = default;
};

/// What stands over every place of a region.
struct ProfileParams {
  std::vector<ProfileSlice> slices;  ///< none: soft, the solution of a Poisson equation; else one
  double follow = 1;                 ///< 1: as thick as the place is wide … 0: as thick as the widest everywhere
  bool operator==(const ProfileParams&) const = default;
  bool isSoft() const { return slices.empty(); }
};

struct InflateParams {
  double height = 1;  ///< 1: a circle becomes a ball; kLeastHeight … kMostHeight
  InflateSides sides = InflateSides::Both;
  int points = 2000;  ///< about so many corners of the mesh; kLeastPoints … kMostPoints
  ProfileParams profile = {};
  bool operator==(const InflateParams&) const = default;
};

inline constexpr double kLeastHeight = 0.05, kMostHeight = 4;
inline constexpr int kLeastPoints = 200, kMostPoints = 16000;
inline constexpr std::size_t kMostSlices = 1;

/// Every number in range and finite; of the slices see checkProfile.
inline bool isValid(const InflateParams& p) {
  return p.height >= kLeastHeight && p.height <= kMostHeight && p.sides < InflateSides::kCount &&
         p.points >= kLeastPoints && p.points <= kMostPoints && p.profile.slices.size() <= kMostSlices &&
         p.profile.follow >= 0 && p.profile.follow <= 1;
}

}  // namespace spineloft::inflate
