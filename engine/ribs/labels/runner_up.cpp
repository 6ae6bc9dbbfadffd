#include "engine/ribs/labels/runner_up.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace spineloft::ribs {
namespace {

// Labels this close (share of the chosen end's arc length, and labels) are the same place.
constexpr float kRunnerUpShare = 0.1f;
constexpr int kSameLabels = 2;
constexpr std::size_t kMostRunnersUp = 3;
// An end on its own at another place costs the chain two jumps between neighbours; one that is dearer
// than this (in units of a rib's energy; RibParams::neighbourCap is 8) has the picture against it too.
constexpr float kMostMargin = 10.f;
// Less support than this is no edge worth offering.
constexpr float kLeastSupport = 0.4f;

float at(std::span<const float> values, int i) { return values[static_cast<std::size_t>(i)]; }
int sizeOf(const RunnerUpRow& row) { return static_cast<int>(row.marginal.size()); }

bool apart(const RunnerUpRow& row, int a, int b) {
  return std::abs(a - b) > kSameLabels &&
         std::abs(at(row.along, a) - at(row.along, b)) > kRunnerUpShare * at(row.along, row.chosen);
}

}  // namespace

double confidenceOf(const RunnerUpRow& row) {
  float rival = std::numeric_limits<float>::infinity();
  for (int k = 0; k < sizeOf(row); ++k) {
    if (apart(row, k, row.chosen)) rival = std::min(rival, at(row.marginal, k));
  }
  const double margin = static_cast<double>(rival - at(row.marginal, row.chosen));
  return 1 - std::exp(-std::max(0.0, margin));
}

std::span<const RunnerUp> findRunnersUp(const RunnerUpRow& row, std::vector<RunnerUp>& memory) {
  memory.clear();
  const float most = at(row.marginal, row.chosen) + kMostMargin * row.unit;
  // Best first; those of equal energy as they stand on the curve.
  const auto add = [&](RunnerUp rival) {
    std::size_t place = memory.size();
    memory.push_back(rival);
    for (; place > 0 && memory[place - 1].marginal > rival.marginal; --place) memory[place] = memory[place - 1];
    memory[place] = rival;
  };
  // Of every edge that the curve passes, the label that is nearest to it.
  int best = -1;
  for (int k = 1; k <= sizeOf(row); ++k) {
    const bool onEdge = k < sizeOf(row) && at(row.support, k) >= kLeastSupport;
    if (onEdge && (best < 0 || at(row.support, k) > at(row.support, best))) best = k;
    if (onEdge || best < 0) continue;
    if (at(row.marginal, best) <= most && apart(row, best, row.chosen)) add({best, at(row.marginal, best)});
    best = -1;
  }
  std::size_t kept = 0;
  for (const RunnerUp& rival : memory) {
    const bool isNew = std::all_of(memory.begin(), memory.begin() + static_cast<std::ptrdiff_t>(kept),
                                   [&](const RunnerUp& other) { return apart(row, other.label, rival.label); });
    if (isNew && kept < kMostRunnersUp) memory[kept++] = rival;
  }
  return {memory.data(), kept};
}

}  // namespace spineloft::ribs
