// What a person chooses about a puff: an inflated region.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/vec.h"
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
  /// The place of the skeleton where the puff has it; from there it passes into the next one along the skeleton. None:
  /// where no other one is near.
  std::optional<PicturePoint> at = std::nullopt;
  bool operator==(const ProfileSlice&) const = default;
};

/// What the width of a slice is, from the bone (x = 0) to the outline.
enum class Across : std::uint8_t {
  Share,   ///< the way there: wide where the place is wide
  Length,  ///< `reach`: an edge of the same width all round, flat within it; no more than the way there
  kCount
};

/// What stands over every place of a region.
struct ProfileParams {
  std::vector<ProfileSlice> slices;  ///< none: soft, the solution of a Poisson equation; up to kMostSlices
  double follow = 1;                 ///< 1: as thick as the place is wide … 0: as thick as the widest everywhere
  Across across = Across::Share;
  double reach = 0.1;  ///< share of the picture's longer side; kLeastReach … kMostReach
  bool operator==(const ProfileParams&) const = default;
  bool isSoft() const { return slices.empty(); }
};

/// The end or fork of the skeleton nearest to `from` goes to `to`, and what leads to it bends along.
struct BoneMove {
  PicturePoint from, to;
  bool operator==(const BoneMove&) const = default;
};
/// What stands over the skeleton near `at` is `factor` times as thick, fading out along it.
struct BoneHeight {
  PicturePoint at;
  double factor = 1;  ///< kLeastFactor … kMostFactor
  bool operator==(const BoneHeight&) const = default;
};
/// What a person changes about the skeleton of a puff; see editSkeleton.
struct BoneEdits {
  double detail = 0.5;                         ///< 0: few branches … 1: many
  std::vector<PicturePoint> drop;              ///< the branch nearest to each goes
  std::vector<std::vector<PicturePoint>> add;  ///< lines from the skeleton to where it should reach, ≥ 2 points
  std::vector<BoneMove> move;
  std::vector<BoneHeight> heights;
  bool operator==(const BoneEdits&) const = default;
};

struct InflateParams {
  double height = 1;  ///< 1: a circle becomes a ball; kLeastHeight … kMostHeight
  InflateSides sides = InflateSides::Both;
  int points = 2000;  ///< about so many corners of the mesh; kLeastPoints … kMostPoints
  ProfileParams profile = {};
  BoneEdits bones = {};  ///< under a profile; a soft puff has no skeleton
  bool operator==(const InflateParams&) const = default;
};

inline constexpr double kLeastHeight = 0.05, kMostHeight = 4;
inline constexpr int kLeastPoints = 200, kMostPoints = 16000;
inline constexpr std::size_t kMostSlices = 8;
inline constexpr std::size_t kMostBoneEdits = 64;        ///< of each kind
inline constexpr std::size_t kMostBoneLinePoints = 256;  ///< of an added line
inline constexpr double kLeastReach = 0.002, kMostReach = 1;
inline constexpr double kLeastFactor = 0.1, kMostFactor = 4;

/// Numbers in range and finite, no more edits than kMostBoneEdits of a kind. Error: ValueOutOfRange, with what is wrong
/// in plain words.
Status checkEdits(const BoneEdits& edits);
/// Every number in range and finite; of the slices see matchedCurves. Error: as above.
Status checkParams(const InflateParams& params);
inline bool isValid(const InflateParams& params) { return checkParams(params).ok(); }

}  // namespace spineloft::inflate
