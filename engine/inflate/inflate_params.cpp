#include "engine/inflate/inflate_params.h"

#include <algorithm>
#include <string>
#include <vector>

#include "engine/base/text.h"

namespace spineloft::inflate {
namespace {

Status inRange(const char* what, double value, double least, double most) {
  if (value >= least && value <= most) return Done{};
  return {Error::ValueOutOfRange, std::string(what) + " must be " + shortNumber(least) + " … " + shortNumber(most)};
}

/// The first one that is none.
Status firstFailure(std::initializer_list<Status> all) {
  for (const Status& status : all) {
    if (!status) return status;
  }
  return Done{};
}

}  // namespace

Status checkEdits(const BoneEdits& edits) {
  const auto refused = [](std::string why) { return Status(Failure{Error::ValueOutOfRange, std::move(why)}); };
  const auto many = [](const auto& list) { return list.size() > kMostBoneEdits; };
  if (many(edits.drop) || many(edits.add) || many(edits.move) || many(edits.heights))
    return refused("more than " + std::to_string(kMostBoneEdits) + " edits of bones of one kind");
  const auto long_ = [](const std::vector<PicturePoint>& line) { return line.size() > kMostBoneLinePoints; };
  if (std::ranges::any_of(edits.add, long_))
    return refused("a bone of more than " + std::to_string(kMostBoneLinePoints) + " points");
  const auto finite = [](PicturePoint p) { return isFinite(p); };
  const bool placed =
      std::ranges::all_of(edits.drop, finite) &&
      std::ranges::all_of(edits.add, [&](const auto& line) { return std::ranges::all_of(line, finite); }) &&
      std::ranges::all_of(edits.move, [](const BoneMove& m) { return isFinite(m.from) && isFinite(m.to); }) &&
      std::ranges::all_of(edits.heights, [](const BoneHeight& h) { return isFinite(h.at); });
  if (!placed) return refused("the place of an edit of bones is not finite");
  if (Status detail = inRange("the detail of bones", edits.detail, 0, 1); !detail) return detail;
  for (const BoneHeight& h : edits.heights) {
    if (Status factor = inRange("the factor of a height", h.factor, kLeastFactor, kMostFactor); !factor) return factor;
  }
  return Done{};
}

Status checkParams(const InflateParams& p) {
  const ProfileParams& profile = p.profile;
  if (p.sides >= InflateSides::kCount) return {Error::ValueOutOfRange, "the sides are front, back or both"};
  if (profile.across >= Across::kCount) return {Error::ValueOutOfRange, "a slice goes across a share or a length"};
  if (profile.slices.size() > kMostSlices)
    return {Error::ValueOutOfRange, "a puff has at most " + std::to_string(kMostSlices) + " slices"};
  if (!std::ranges::all_of(profile.slices, [](const ProfileSlice& s) { return !s.at || isFinite(*s.at); }))
    return {Error::ValueOutOfRange, "the place of a slice is not finite"};
  return firstFailure(
      {inRange("the height", p.height, kLeastHeight, kMostHeight),
       inRange("the points", p.points, kLeastPoints, kMostPoints), inRange("follow", profile.follow, 0, 1),
       inRange("the reach of a slice across a length", profile.reach, kLeastReach, kMostReach), checkEdits(p.bones)});
}

}  // namespace spineloft::inflate
