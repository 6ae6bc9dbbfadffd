// What a region has inside that does not depend on what stands over it: its skeleton, and the fields between that and
// its outlines.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/base/result.h"
#include "engine/geometry/region.h"
#include "engine/inflate/bone_edits.h"
#include "engine/inflate/fields.h"

namespace spineloft::inflate {

struct Interior {
  std::vector<geometry::Contours> pieces;  ///< connected ones
  std::vector<EditedSkeleton> bones;       ///< one a piece
  std::vector<Fields> fields;              ///< one a piece
};

/// How fine skeleton and fields are for a mesh of so many corners, 0.4 … 1: from 2,000 on as fine as they get; below,
/// their points lie apart in inverse proportion to the corners.
double finenessFor(int points);

/// For a mesh of so many corners. Of the slices only the places count. Errors: those of editedSkeleton and fieldsOf.
Result<Interior> interiorOf(const geometry::Contours& contours, const BoneEdits& edits,
                            std::span<const ProfileSlice> slices, int points);

std::size_t bytesOf(const std::vector<EditedSkeleton>& bones);
std::size_t bytesOf(const Interior& interior);

}  // namespace spineloft::inflate
