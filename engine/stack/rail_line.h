// The rail of a stack as a smooth line with frames. Internal to stack/.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/base/result.h"
#include "engine/geometry/frames.h"
#include "engine/stack/stack_params.h"

namespace spineloft::stack {

class RailLine {
 public:
  /// Cubic arcs through the rail's points, with rotation-minimising frames that begin with the direction to the right
  /// of the way as the viewer sees it. Error: StackInvalid (no length, a closed one of fewer than 3 points).
  static Result<RailLine> of(const Rail& rail);

  double length() const { return lengths_.back(); }  ///< picture pixels, > 0
  bool closed() const { return closed_; }
  /// At a share of the length; of a closed rail any number, whole ones at its first point, else clamped to 0…1.
  geometry::Frame at(double share) const;
  /// Where it goes through the rail's point number `point`, of those that are no repeats: share of the length.
  double shareOf(std::size_t point) const { return lengths_[point * steps_] / length(); }
  /// Towards the centre of the bend, 1 over its radius, 1/px.
  ModelPoint bend(double share) const;

 private:
  std::vector<geometry::Frame> frames_;
  std::vector<double> lengths_;  ///< from the first frame to each
  std::size_t steps_ = 1;        ///< frames from one of the rail's points to the next
  bool closed_ = false;
};

}  // namespace spineloft::stack
