// Final smoothing of rib lengths: from labels to a fair line through the ends that are reliable (method:
// "Second-order smoothness").
#pragma once

#include <span>
#include <vector>

#include "engine/ribs/base/rib_params.h"

namespace spineloft::ribs {

/// One side's lengths in order along the spine, picture pixels, and how much each is to be believed,
/// 0…1.
struct SideLengths {
  std::vector<double> length, trust;
};

/// Minimises Σ w_i (x_i − length_i)² + stiffness Σ q_i (x_{i−1} − 2 x_i + x_{i+1})² over x, where w
/// is the trust and both sums are made robust by four rounds of reweighting (Geman and McClure's
/// weights: 1 / (1 + (residual / scale)²)²). Lengths come back unchanged below five entries and with a
/// stiffness of 0. Straight lines, whatever their slope, come back unchanged. O(n).
/// The result stands in `memory.fair`.
struct FairingMemory {
  std::vector<double> fair, next, diagonal, first, second;
};
const std::vector<double>& fairLengths(const SideLengths& side, const FairingParams& params, FairingMemory& memory);

}  // namespace spineloft::ribs
