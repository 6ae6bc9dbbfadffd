// The spine where it was traced and where it stands: what carries ribs and sections from the one to
// the other (SpineLoft 4, "reposing"; method: "Loft").
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/vec.h"
#include "engine/geometry/frames.h"
#include "engine/geometry/stroke_line.h"
#include "engine/loft/pose.h"
#include "engine/ribs/base/rib_set.h"
#include "engine/ribs/base/spine.h"

namespace spineloft::loft {

/// Frames at even shares of the traced spine's length, ModelSpace: `rest` on the traced spine, in the
/// plane z = 0; `posed` on the line on which it stands, rotation-minimising, beginning with the
/// direction of the ribs in the picture's plane. Equal numbers, ≥ 2.
struct PosedSpine {
  std::vector<geometry::Frame> rest, posed;
  double scale = 1;     ///< of everything across: length of the pose's stroke over that of the spine
  bool moved = false;   ///< false: the pose changes nothing
  bool closed = false;  ///< the last posed frame is the first
};

/// The traced spine in a pose. Without a stroke the line is the traced one; depth comes on top of it,
/// and the coil winds round that, its radius growing from 0 over at most half a turn at both ends. A
/// closed line is bent evenly until its ends meet with one tangent (a straight one becomes a circle);
/// a coil on it has whole turns. Places along the spine stay at their share of the flat line's length.
/// The stroke may leave the picture and cross itself.
/// Errors: StrokeTooShort, StrokeNotFinite, ValueOutOfRange (not a valid pose).
Result<PosedSpine> poseSpine(const ribs::Spine& rest, const Pose& pose);

/// Buffers of poseSpine, reused from frame to frame; results do not depend on their contents.
struct PoseMemory {
  geometry::StrokeMemory stroke;
  std::vector<PicturePoint> traced, line;
  std::vector<ModelPoint> refined, tangents;
};
/// The same into `spine`, replacing what it held. Allocates nothing once both have seen spines of as many points,
/// where the pose neither winds nor closes the line. After a failure `spine` is of no use.
Status poseSpine(const ribs::Spine& rest, const Pose& pose, PoseMemory& memory, PosedSpine& spine);

/// Share of the spine's length, 0…1, at the place of the traced spine nearest to `p`.
double shareAt(const PosedSpine& spine, PicturePoint p);

/// Where a point of the picture's plane, `height` picture pixels before it, is carried by the frame
/// at share `at` (0…1). Unmoved spines: {x, −y, height}.
ModelPoint carried(const PosedSpine& spine, double at, PicturePoint p, double height = 0);

/// The point that is carried to where it is seen from the front at `seen`; none when the frame is seen
/// from its edge.
std::optional<PicturePoint> atRest(const PosedSpine& spine, double at, PicturePoint seen);

/// Ribs and fans in the pose, seen from the front. Unmoved: unchanged.
ribs::RibSet poseRibs(const PosedSpine& spine, const ribs::RibSet& ribs);
/// The same in place.
void carryRibs(const PosedSpine& spine, ribs::RibSet& ribs);

/// `count` ≥ 2 points of the posed line at even shares.
std::vector<ModelPoint> centreLine(const PosedSpine& spine, std::size_t count);
void centreLine(const PosedSpine& spine, std::size_t count, std::vector<ModelPoint>& line);

}  // namespace spineloft::loft
