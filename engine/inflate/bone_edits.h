// What a person changes about the skeleton of a region: branches left out, drawn, moved, and made thicker.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
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
  std::vector<char> drop, add, move, heights, slices;  ///< slices without a place are awake
  bool operator==(const AwakeEdits&) const = default;
};

/// A branch that an edit left out.
struct GoneBranch {
  std::size_t drop = 0;  ///< of BoneEdits::drop
  std::vector<SectionPoint> line;
};

struct EditedSkeleton {
  Skeleton skeleton;
  AwakeEdits awake;
  std::vector<GoneBranch> gone;
  std::vector<std::uint32_t> reached;  ///< by BoneEdits::add: the point where its branch ends; kNoPoint: it sleeps
};
inline constexpr std::uint32_t kNoPoint = std::numeric_limits<std::uint32_t>::max();

/// The skeleton of one connected piece with the edits, which are picture points, laid over it: branches that go, those
/// that come, moves, thickness. An edit belongs to the place of the skeleton nearest to its point when that lies in the
/// largest disc there. A dropped branch takes along what hangs on it away from the rings, or from the largest disc;
/// cycles cannot be dropped. An added line ends where it leaves the region, and begins where it last crosses the
/// skeleton. An edit that would make the skeleton cross itself or leave the region sleeps. A slice with a place is what
/// the puff has at the point nearest to it, and passes along the skeleton into others: its share minimises ∫ f'², where
/// a slice has no place ∫ f'² + (f/2R)², which fades into that one. Errors: those of skeletonOf.
Result<EditedSkeleton> editedSkeleton(const geometry::Contours& piece, const BoneEdits& edits,
                                      std::span<const ProfileSlice> slices = {}, double fineness = 1);

/// Whether an edit found its place in a piece. `kind`: a member of AwakeEdits.
bool isAwake(std::span<const EditedSkeleton> pieces, std::vector<char> AwakeEdits::* kind, std::size_t number);
/// How many edits no piece has found.
int asleep(std::span<const EditedSkeleton> pieces);

}  // namespace spineloft::inflate
