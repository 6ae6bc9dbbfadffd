// Uneven surfaces of stacks: rings moved by noise. Internal to stack/.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/stack/network.h"
#include "engine/stack/stack_params.h"

namespace spineloft::stack {

class Roughness {
 public:
  explicit Roughness(const Rough& rough) : rough_(rough) {}
  bool any() const { return rough_.amount > 0; }

  /// Moves closed curves in their plane, every point square to its curve by at most `share` of the amount, and not
  /// farther than the radius of the circle of the curve's area. False where curves would cross themselves or each other
  /// then, or lose more than three quarters of their area: the figure stays as it is.
  /// `figure`: counter-clockwise, one curve after the other, `sizes` points each; `places`: where they are in space.
  bool move(std::vector<SectionPoint>& figure, std::span<const std::size_t> sizes, std::span<const ModelPoint> places,
            double share = 1) const;
  /// What share of the amount counts `away` (pixels) from the nearest sheet.
  double shareAt(double away) const;
  /// How many rows there must be on a way of this length, for bumps to be round; 1 without any.
  int rowsOf(double length) const;
  /// Moves the rings of all curves of a network, those of a sheet together, unless drawn curves stay. False where one
  /// cannot be.
  bool moveRings(const Sheets& sheets, Network& network) const;

 private:
  Rough rough_;
};

}  // namespace spineloft::stack
