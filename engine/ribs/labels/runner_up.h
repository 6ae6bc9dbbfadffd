// Confidence of an end in its label, and its next-best labels: read from the min-marginals.
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

/// 1 − exp(−margin). The margin is the additional cost of the best label at another place; labels next to the chosen
/// one are the same place.
double confidenceOf(const RunnerUpRow& row);

/// A place with an edge, and the least energy through it.
struct RunnerUp {
  int label = 0;
  float marginal = 0;
};

/// The labels of the next-best places, best first, at most three: on an edge, within a bounded cost, apart from each
/// other and from the chosen label. `memory` is reused.
std::span<const RunnerUp> findRunnersUp(const RunnerUpRow& row, std::vector<RunnerUp>& memory);

}  // namespace spineloft::ribs
