// The profile of a puff: one half of a slice, from the bone to the outline.
#pragma once

#include <span>
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

/// The curves of all slices: by curve the same one in each slice. Every slice has as many bodies, rings and holes as
/// the first. Errors: those of profileCurves; SectionInvalid for slices that do not match, that would cross themselves
/// on the way from one to another, or more than one of which has no place.
using MatchedCurves = std::vector<std::vector<ProfileCurve>>;
Result<MatchedCurves> matchedCurves(std::span<const ProfileSlice> slices, InflateSides sides);

/// One slice, and of it one curve without a corner that goes from the axis out and back once: no stretches of what it
/// makes lie near each other but where the region is narrow.
bool isPlain(const MatchedCurves& curves);

/// Shells and handles of what a profile makes of one piece of a region with `holes` holes: every curve from axis to
/// axis is a body with as many handles, every other one a ring along each outline.
struct Topology {
  int shells = 0, genus = 0;
};
Topology topologyOf(const std::vector<ProfileCurve>& curves, int holes);

/// A row: its place (s, z) in each slice.
using ProfileRow = std::vector<SectionPoint>;
/// Rows of one curve, given as it is in each slice: about `step` apart (half widths) in the slice where it is longest,
/// corners kept, none nearer to the axis than kNearAxis but on it.
std::vector<ProfileRow> rowsOf(std::span<const ProfileCurve> curve, double step);
inline constexpr double kNearAxis = 0.02;

}  // namespace spineloft::inflate
