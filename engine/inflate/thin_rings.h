// Rings of a profile that are too thin to be seen.
#pragma once

#include <span>

#include "engine/image/image.h"
#include "engine/inflate/bone_edits.h"
#include "engine/inflate/inflate_params.h"
#include "engine/inflate/profile.h"

namespace spineloft::inflate {

/// No ring is drawn thinner than this share of the picture's longer side where the region is widest; its thickness is
/// twice its area over its length.
inline constexpr double kLeastRing = 0.002;

/// Makes the thinner ones so thick, all round; where that would take one out of the region or through the
/// picture's plane it is moved, where it would meet another curve it stays as it was drawn. How many are thicker now.
/// `bones`: of all pieces of the region.
int thickenRings(MatchedCurves& curves, std::span<const EditedSkeleton> bones, image::Size picture,
                 const InflateParams& params);

/// How many rings of this puff are drawn thicker than its slices say; 0 where the slices make no puff.
int thinRings(std::span<const EditedSkeleton> bones, image::Size picture, const InflateParams& params);

}  // namespace spineloft::inflate
