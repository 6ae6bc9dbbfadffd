// What a person changes about the skeleton of a region: branches left out, drawn, moved, and made thicker.
#pragma once

#include <vector>

#include "engine/base/result.h"
#include "engine/geometry/region.h"
#include "engine/inflate/inflate_params.h"
#include "engine/inflate/skeleton.h"

namespace spineloft::inflate {

/// The scale of skeletonOf for a detail of 0 … 1: 3 at 0, kScale at ½, 1.1 at 1, geometric in between.
double scaleFor(double detail);

/// By edit, in the order of BoneEdits: whether it found its place. One that did not sleeps: it changes nothing, and may
/// find it in another outline.
struct AwakeEdits {
  std::vector<char> drop, add, move, heights;
  bool operator==(const AwakeEdits&) const = default;
};

struct EditedSkeleton {
  Skeleton skeleton;
  AwakeEdits awake;
};

/// The skeleton of one connected piece with the edits, which are picture points, laid over it: branches that go, those
/// that come, moves, thickness. An edit belongs to the place of the skeleton nearest to its point when that lies in the
/// largest disc there. A dropped branch takes along what hangs on it away from the rings, or from the largest disc;
/// cycles cannot be dropped. An added line ends where it leaves the region, and begins where it last crosses the
/// skeleton. An edit that would make the skeleton cross itself or leave the region sleeps. Errors: those of skeletonOf.
Result<EditedSkeleton> editedSkeleton(const geometry::Contours& piece, const BoneEdits& edits);

/// How many edits no piece has found.
int asleep(const std::vector<EditedSkeleton>& pieces, const BoneEdits& edits);

}  // namespace spineloft::inflate
