// The profile of a puff: one half of a slice, from the bone to the outline.
#pragma once

#include <vector>

#include "engine/base/result.h"
#include "engine/base/vec.h"
#include "engine/inflate/inflate_params.h"

namespace spineloft::inflate {

/// A curve that bounds a profile: points (s, z), s the share of the way from bone to outline (0…1), z towards the
/// viewer in half widths; the solid lies on its left.
struct ProfileCurve {
  std::vector<SectionPoint> points;
  bool closed = false;  ///< beside the axis s = 0; else its first and last point, and no other, lie on it
};

/// The right half of a slice that is the same on its left, cut at z = 0 for one side only. Slices are taken as drawn:
/// x = ±1 is the outline, and a slice may end before it. Errors: SectionInvalid with what is wrong in plain words:
/// those of checkShape; lopsided; beyond the outline; only touching the axis; nothing on the side that is asked for.
Result<std::vector<ProfileCurve>> profileCurves(const sections::SectionShape& shape, InflateSides sides);

/// Shells and handles of what a profile makes of one piece of a region with `holes` holes: every curve from axis to
/// axis is a body with as many handles, every other one a ring along each outline.
struct Topology {
  int shells = 0, genus = 0;
};
Topology topologyOf(const std::vector<ProfileCurve>& curves, int holes);

/// The curve with points about `step` apart (half widths), corners kept, none nearer to the axis than kNearAxis but on
/// it.
ProfileCurve withRows(const ProfileCurve& curve, double step);
inline constexpr double kNearAxis = 0.02;

}  // namespace spineloft::inflate
