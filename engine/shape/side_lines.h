// The two lines of an outline along an axis. Internal to shape/.
#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/vec.h"

namespace spineloft::shape {

/// Points with x across the axis and y along it, pixels of the part's picture.
using Line = std::vector<SectionPoint>;

/// A line from the start of the axis to its end, which may step back a little on the way.
///
/// Its points are known by a share 0…1, which grows along it. Where it always goes ahead, but for a hair, that is the
/// place along the axis, between its own ends. Else it is for 19 parts of 20 how far along the axis it ever came,
/// and for one part its length, so that a stretch that steps back or goes across has shares of its own, and the other
/// lines hardly move meanwhile.
class SideLine {
 public:
  /// At least two points, of which the last lies ahead of the first. What runs straight across at its ends goes.
  explicit SideLine(Line points);
  const Line& points() const { return points_; }
  const std::vector<double>& shares() const { return shares_; }  ///< of each point
  double start() const { return points_.front().y; }
  double end() const { return points_.back().y; }
  double steppedBack() const { return back_; }  ///< the farthest way back along the axis
  /// Places along the axis from [from, to] to [newFrom, newTo].
  void stretch(double from, double to, double newFrom, double newTo);
  SectionPoint at(double share) const;
  /// Shares at which it turns sharply.
  std::vector<double> corners() const;

 private:
  Line points_;
  std::vector<double> shares_;
  double back_ = 0;
};

/// `low` where x is less, both from start to end.
struct SideLines {
  SideLine low, high;
  double start() const { return (low.start() + high.start()) / 2; }
  double end() const { return (low.end() + high.end()) / 2; }
  double length() const { return end() - start(); }
  double widest() const;  ///< of x from end to end
  /// Brings lines of a side view to the places [from, to] of the front. Error: ShapeInvalid (they are longer or shorter
  /// by more than a quarter, or stand beside it by more than that).
  Status stretchTo(double from, double to);
};

/// The two lines of an outline: one closed line, split where it reaches farthest along the axis, or two open ones in
/// any order and direction. `name` begins sentences ("The outline"). Errors: RegionEmpty (under 12 square pixels, or
/// nothing along the axis), ShapeInvalid (it crosses itself by more than a slip of the hand; its lines cross; it turns
/// back along the axis by more than a tenth of its length).
Result<SideLines> sideLinesOf(std::vector<Line> lines, const std::string& name);

}  // namespace spineloft::shape
