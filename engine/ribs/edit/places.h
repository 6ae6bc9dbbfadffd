// Places along a spine as shares of its length, and the frame there: what edits are measured in.
#pragma once

#include <span>
#include <vector>

#include "engine/base/vec.h"
#include "engine/ribs/edit/edits.h"

namespace spineloft::ribs {

/// Places closer than this (shares of the length) are the same place.
inline constexpr double kSamePlace = 1e-9;

/// A polyline with its arc lengths. ≥ 1 point; the points must outlive it. All points are picture
/// pixels, all places shares of the length, clamped to 0…1.
class Ruler {
 public:
  explicit Ruler(std::span<const PicturePoint> points);
  double length() const { return lengths_.back(); }
  PicturePoint pointAt(double at) const;
  /// Unit tangent in the drawing direction, smoothed over a few hundredths of the length; changes
  /// continuously with `at`. {1, 0} for a line without length.
  PicturePoint tangentAt(double at) const;
  /// Unit normal at `at` towards a side; left as seen on the screen in the drawing direction.
  PicturePoint outAt(double at, Side side) const;
  /// The place nearest to `p`.
  double placeOf(PicturePoint p) const;
  /// The place of the i-th point.
  double placeOfPoint(std::size_t i) const;
  /// From a point to an edit's coordinates (EndEdit::along, EndEdit::out) and back.
  PicturePoint fromFrame(const EndEdit& edit) const;
  void toFrame(PicturePoint p, EndEdit& edit) const;

 private:
  std::span<const PicturePoint> points_;
  std::vector<double> lengths_;
};

/// Where every rib stands: the places of the ribs' centres.
std::vector<double> ribPlaces(const Ruler& ruler, const Spine& spine, const RibSet& ribs);

/// How much of an edit an end feels whose distance is `share` of the reach: from 1 at 0 to 0 at 1
/// and beyond, smooth, and bell(u) + bell(1 − u) = 1, so that edits one reach apart blend evenly.
double bell(double share);

}  // namespace spineloft::ribs
