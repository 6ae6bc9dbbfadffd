#include <cmath>
#include <span>

#include "engine/ribs/labels/runner_up.h"
#include "engine/ribs/search/end_search.h"
#include "engine/ribs/search/rib_search.h"

namespace spineloft::ribs {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// Edge where the end stands on one; Bridged between two of those; else Guessed.
const std::vector<RibState>& endStates(const std::vector<int>& labels, bool leftSide, Search& s) {
  const int ribs = s.problem.ribs;
  std::vector<RibState>& states = s.states;
  states.assign(index(ribs), RibState::Guessed);
  int last = -1;
  for (int i = 0; i < ribs; ++i) {
    const int curve = s.curves.layout.sideOf(i, leftSide);
    if (!s.boundary.isOnEdge(s.curves.at(curve, labels[index(i)]))) continue;
    states[index(i)] = RibState::Edge;
    if (last >= 0) std::fill(&states[index(last + 1)], &states[index(i)], RibState::Bridged);
    last = i;
  }
  return states;
}

// Confidence and other places of the ends of one side, from its min-marginals. Places on an edge of the picture are
// offered, likely or not.
void readRunnersUp(Search& s, const LengthLabels& labels, bool leftSide, RibSet& set) {
  std::vector<float>& marginals = s.marginals;
  sideMarginals(s.problem, labels, leftSide, s.workspace, marginals);
  for (int i = 0; i < s.problem.ribs; ++i) {
    const int curve = s.curves.layout.sideOf(i, leftSide);
    const std::size_t reached = index(s.curves.reached[index(curve)]);
    const auto row = [&](const std::vector<float>& values, std::size_t first) {
      return std::span<const float>(&values[first], reached);
    };
    const std::size_t first = s.curves.at(curve, 0);
    const RunnerUpRow runnersUp{row(marginals, index(i) * index(s.problem.levels)), row(s.curves.along, first),
                                row(s.edges ? s.strip.proximity : s.boundary.support, first),
                                (leftSide ? labels.left : labels.right)[index(i)], static_cast<float>(shareOfRib(s))};
    Rib& rib = set.ribs[index(i)];
    (leftSide ? rib.leftConfidence : rib.rightConfidence) = confidenceOf(runnersUp);
    OtherPlaces& others = leftSide ? rib.leftOthers : rib.rightOthers;
    for (const RunnerUp& rival : findRunnersUp(runnersUp, s.runnersUp)) {
      others.at[index(others.count++)] = s.curves.point(curve, rival.label);
    }
  }
}

// Where the boundary is between the labels next to the chosen one: the mean of their places, by their chances.
double placeBetween(const Search& s, int curve, int label) {
  constexpr int kNext = 2;
  const std::size_t row = s.curves.at(curve, 0);
  const int last = s.curves.reached[index(curve)] - 1;
  const double own = s.curves.along[row + index(label)];
  double sum = 0, mass = 0;
  for (int k = std::max(1, label - kNext); k <= std::min(last, label + kNext); ++k) {
    const auto chance = static_cast<double>(s.boundary.chance[row + index(k)]);
    sum += chance * (static_cast<double>(s.curves.along[row + index(k)]) - own);
    mass += chance;
  }
  // A chance of one label has to be there before the others can move it.
  constexpr double kLeast = 0.02;
  return own + sum / std::max(kLeast, mass);
}

// Where the ends of one side stand: the labels' places, made fair.
const std::vector<double>& endLengths(const std::vector<int>& labels, bool leftSide, Search& s) {
  SideLengths& side = s.lengths;
  side.length.clear();
  side.trust.clear();
  for (int i = 0; i < s.problem.ribs; ++i) {
    const int curve = s.curves.layout.sideOf(i, leftSide);
    const std::size_t at = s.curves.at(curve, labels[index(i)]);
    const auto support = static_cast<double>(s.boundary.support[at]);
    side.length.push_back(placeBetween(s, curve, labels[index(i)]));
    side.trust.push_back(support * support);
  }
  return fairLengths(side, s.params.fairing, s.fairing);
}

// One side's ends of `set` at arc lengths along their curves.
void placeSide(bool leftSide, const std::vector<double>& lengths, Search& s, RibSet& set) {
  const std::vector<int>& labels = leftSide ? s.labels.left : s.labels.right;
  const std::vector<RibState>& states = endStates(labels, leftSide, s);
  for (int i = 0; i < s.problem.ribs; ++i) {
    Rib& rib = set.ribs[index(i)];
    const int curve = s.curves.layout.sideOf(i, leftSide);
    rib.center = s.spine.points[index(i)];
    (leftSide ? rib.left : rib.right) = s.curves.pointAlong(curve, lengths[index(i)]);
    (leftSide ? rib.leftState : rib.rightState) = states[index(i)];
    (leftSide ? rib.leftLevel : rib.rightLevel) = s.levels.d2[index(labels[index(i)])];
  }
}

}  // namespace

void readRibs(bool withRivals, Search& s, RibSet& set) {
  set.ribs.assign(index(s.problem.ribs), Rib{});
  for (const bool leftSide : {true, false})
    placeSide(leftSide, endLengths(leftSide ? s.labels.left : s.labels.right, leftSide, s), s, set);
  if (withRivals) {
    readRunnersUp(s, s.labels, true, set);
    readRunnersUp(s, s.labels, false, set);
  }
  findEnd(true, set, s);
  findEnd(false, set, s);
  set.energy = energyOf(s.problem, s.labels);
}

}  // namespace spineloft::ribs
