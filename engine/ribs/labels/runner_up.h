// How sure an end is of its label, and where else it might stand: read from the min-marginals.
#pragma once

#include <span>
#include <vector>

namespace spineloft::ribs {

/// One gradient curve at the labels that it reaches, all spans of the same size ≥ 1.
struct RunnerUpRow {
  std::span<const float> marginal;  ///< least energy of the chain through each label
  std::span<const float> along;     ///< arc length from the spine, picture pixels
  std::span<const float> support;   ///< whether there is an edge, 0…1
  int chosen = 0;
  float unit = 1;  ///< weight of one rib's energy against that of one of a hundred
};

/// 1 − exp(−margin), where the margin is how much more the best label costs that is another place,
/// not the same one next door.
double confidenceOf(const RunnerUpRow& row);

/// A place with an edge, and the least energy through it.
struct RunnerUp {
  int label = 0;
  float marginal = 0;
};

/// The labels of the next-best places, best first, at most three: where the curve passes an edge and
/// the chain through it costs no hopeless amount more; apart from each other and from the chosen one.
/// `memory` is reused.
std::span<const RunnerUp> findRunnersUp(const RunnerUpRow& row, std::vector<RunnerUp>& memory);

}  // namespace spineloft::ribs
