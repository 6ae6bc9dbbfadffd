#include "engine/ribs/search/outer_hypothesis.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/ribs/search/rib_search.h"

namespace spineloft::ribs {
namespace {

// Inside and the ring outside, as shares of the length of a rib; and a margin of the ring in map pixels.
constexpr float kInside = 0.93f, kRingFrom = 1.07f, kRingTo = 1.6f, kRingMargin = 4;
// Cells of a channel that are merged into one, because noise spreads over neighbouring cells.
constexpr int kMerged = 2;
constexpr int kCoarse = kColourBins / kMerged;
static_assert(kColourBins % kMerged == 0);
constexpr std::size_t kCells = std::size_t{kCoarse} * kCoarse * kCoarse;
// A part is farther out if its lengths are at least kFarther times as large; labels nearer than that cost kNearCost
// more.
constexpr float kOuter = 1.15f, kNearCost = 1.25f;
// A part farther out is taken if its score (coloursApart minus kUneven · unevenness) is better by kClearly and its
// mean cost of a rib is higher by at most kMostDearer, for the second part farther out kMostDearerTwice.
constexpr double kClearly = 0.05, kUneven = 1.2, kMostDearer = 1, kMostDearerTwice = 0.6;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

std::size_t coarseCell(std::uint16_t cell) {
  const int light = cell / (kColourBins * kColourBins), a = cell / kColourBins % kColourBins, b = cell % kColourBins;
  return index((light / kMerged * kCoarse + a / kMerged) * kCoarse + b / kMerged);
}

/// Calls `what` with the curve and the label of every end.
template <class What>
void forEnds(const GradientCurves& curves, const LengthLabels& ends, What&& what) {
  for (int i = 0; i < curves.layout.ribs; ++i) {
    what(curves.layout.left(i), ends.left[index(i)]);
    what(curves.layout.right(i), ends.right[index(i)]);
  }
}

double scoreOf(const Search& s, const LengthLabels& labels) {
  return coloursApart(s.curves, s.strip, s.terms.scratch.colours, labels) - kUneven * unevenness(s.curves, labels);
}

// Raises the costs of all labels that are nearer than a part farther out may have.
void chargeNear(const std::vector<int>& found, float cost, int levels, SideCosts& side) {
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::size_t row = i * index(levels);
    const float least = kOuter * side.place[row + index(found[i])];
    for (std::size_t k = row; k < row + index(levels) && side.place[k] < least; ++k) side.unary[k] += cost;
  }
}

// The best part farther out than `nearer`, into `s.trial`; false if it costs more than `limit`.
bool findOuterHypothesis(const LengthLabels& nearer, double limit, Search& s) {
  const float cost = kNearCost * static_cast<float>(shareOfRib(s));
  s.ownLeft = s.problem.left.unary;
  s.ownRight = s.problem.right.unary;
  chargeNear(nearer.left, cost, s.problem.levels, s.problem.left);
  chargeNear(nearer.right, cost, s.problem.levels, s.problem.right);
  const bool found = findLabels(s.problem, limit, s.workspace, s.trial);
  s.problem.left.unary.swap(s.ownLeft);
  s.problem.right.unary.swap(s.ownRight);
  return found && energyOf(s.problem, s.trial).total() <= limit;
}

}  // namespace

double coloursApart(const GradientCurves& curves, const UnwrappedImage& strip, const ColourTables& colours,
                    const LengthLabels& ends) {
  std::array<float, kCells> inside{}, outside{};
  const float margin = kRingMargin * static_cast<float>(strip.pixel);
  forEnds(curves, ends, [&](int curve, int label) {
    const std::size_t row = curves.at(curve, 0), end = row + index(curves.reached[index(curve)]);
    const float* along = curves.along.data();
    const float length = along[row + index(label)];
    const float last = kRingTo * length + margin;
    for (std::size_t k = row + 1; k < end && along[k] <= last; ++k) {
      const bool in = along[k] <= kInside * length;
      if ((!in && along[k] < kRingFrom * length) || strip.isIgnored(k)) continue;
      (in ? inside : outside)[coarseCell(colours.cells[k])] += along[k] - along[k - 1];
    }
  });
  double allInside = 0, allOutside = 0, common = 0;
  for (std::size_t i = 0; i < kCells; ++i) {
    allInside += static_cast<double>(inside[i]);
    allOutside += static_cast<double>(outside[i]);
    common += std::sqrt(static_cast<double>(inside[i]) * static_cast<double>(outside[i]));
  }
  if (!(allInside > 0) || !(allOutside > 0)) return 0;
  return 1 - common / std::sqrt(allInside * allOutside);
}

double unevenness(const GradientCurves& curves, const LengthLabels& ends) {
  double turns = 0, all = 0;
  for (const bool left : {true, false}) {
    const std::vector<int>& labels = left ? ends.left : ends.right;
    const auto length = [&](int i) {
      return static_cast<double>(curves.along[curves.at(curves.layout.sideOf(i, left), labels[index(i)])]);
    };
    for (int i = 0; i < curves.layout.ribs; ++i) {
      all += length(i);
      if (i > 0 && i + 1 < curves.layout.ribs) turns += std::abs(length(i - 1) - 2 * length(i) + length(i + 1));
    }
  }
  return all > 0 ? turns / all : 0;
}

void tryOuterHypothesis(Search& s) {
  const double perRib = s.problem.ribs * shareOfRib(s);
  const double found = energyOf(s.problem, s.labels).total(), score = scoreOf(s, s.labels);
  s.nearer = s.labels;
  for (const double dearer : {kMostDearer, kMostDearerTwice}) {
    if (!findOuterHypothesis(s.nearer, found + dearer * perRib, s)) return;
    if (scoreOf(s, s.trial) > score + kClearly) {
      std::swap(s.labels, s.trial);
      return;
    }
    std::swap(s.nearer, s.trial);
  }
}

}  // namespace spineloft::ribs
