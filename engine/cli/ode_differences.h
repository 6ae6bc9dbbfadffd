// The finite differences of the paper (ode-character-modelling, equations 6 to 9 and 11): what the closed forms of
// geometry/ode.h are compared with. They compute nothing that a person sees.
#pragma once

#include <span>
#include <vector>

#include "engine/geometry/ode.h"

namespace spineloft::cli {

/// k_b d'''' − k_s d'' at every inner node of `values`, which stand at t = 0, 1/n … 1, with k_b = 1 and k_s = λ²
/// (equation 6), with ghost nodes before and after by the end slopes of `ends` (equation 9): n − 1 numbers.
std::vector<double> differenceForces(std::span<const double> values, const geometry::OdeEnds& ends, double tightness);

/// The solution of the same with these forces at the inner nodes: forces.size() + 2 values from t = 0 to 1. At least
/// one force. Cost: linear.
std::vector<double> differenceCurve(const geometry::OdeEnds& ends, double tightness, std::span<const double> forces);

/// A value that is known at one node of a ring.
struct RingNode {
  std::size_t at = 0;
  double value = 0;
};
/// The closed curve on `nodes` even places that keeps the known values and solves the equation at every other node
/// (equation 11). At least one known value, 5 nodes or more. Cost: the cube of the nodes.
std::vector<double> differenceRing(std::span<const RingNode> known, double tightness, std::size_t nodes);

}  // namespace spineloft::cli
