// A ring on a surface: what lies within it. Internal to pull/.
#pragma once

#include <span>
#include <vector>

#include "engine/base/vec.h"

namespace spineloft::pull {

/// A closed line on a surface, with the surface's normals along it: they say which way within is.
class Ring {
 public:
  struct Corner {
    ModelPoint at, normal;  ///< unit: of the surface there
  };
  /// At least three corners. Within is on their left, seen from outside of the solid, if they go round the mean of
  /// their normals counter-clockwise, else on their right.
  explicit Ring(std::span<const Corner> corners);

  /// Of a ring whose normals have no mean to speak of, as round an arm: within is the side where `p` is.
  void turnTo(ModelPoint p);
  /// How far a place of the surface is from the ring; < 0: beyond it, as the nearest side sees it. Cost: that of the
  /// sides.
  double depth(ModelPoint p) const;
  /// Within the ring, seen along its own normal (Newell's).
  double area() const { return area_; }
  double length() const { return length_; }

 private:
  struct Side {
    ModelPoint from, along, within;  ///< to the next corner; unit: on the surface, square to that
    ModelPoint withinAtCorner;       ///< mean of this side and the one before
  };
  std::vector<Side> sides_;
  double area_ = 0, length_ = 0;
  bool turned_ = true;  ///< its normals have a mean
};

}  // namespace spineloft::pull
