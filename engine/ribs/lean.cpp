#include "engine/ribs/lean.h"

#include <algorithm>
#include <cmath>

namespace spineloft::ribs {
namespace {

constexpr int kWidths = 96;
constexpr int kLeans = 3;        // tried to either side of 0
constexpr int kRefinements = 2;  // halvings of the step around the best
// What a place costs that lies beyond the last label of a rib (the picture's frame): more than no
// evidence at all, less than a contradiction.
constexpr float kBeyondCost = 0.4f;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// Adds one side's costs at the places factor · width[j], interpolated between labels.
void addSide(const LengthProblem& p, const SideCosts& side, int rib, float factor,
             const std::vector<float>& widths, float* costs) {
  const float* place = &side.place[index(rib) * index(p.levels)];
  const float* unary = &side.unary[index(rib) * index(p.levels)];
  int k = 0;
  for (int j = 0; j < kWidths; ++j) {
    const float at = factor * widths[index(j)];
    while (k + 2 < p.levels && place[k + 1] <= at) ++k;
    const float share = std::clamp((at - place[k]) / (place[k + 1] - place[k]), 0.f, 1.f);
    const bool low = unary[k] < kUnreachable, high = unary[k + 1] < kUnreachable;
    float cost = kBeyondCost;
    if (low && high) {
      cost = unary[k] + (unary[k + 1] - unary[k]) * share;
    } else if (low || high) {
      cost = low ? unary[k] : unary[k + 1];
    }
    costs[j] += cost;
  }
}

std::vector<float> widthGrid(const LengthProblem& p, double narrowest) {
  float widest = static_cast<float>(2 * narrowest);
  for (const SideCosts* side : {&p.left, &p.right}) {
    for (std::size_t i = 0; i < side->unary.size(); ++i) {
      if (side->unary[i] < kUnreachable) widest = std::max(widest, 2 * side->place[i]);
    }
  }
  std::vector<float> widths(kWidths);
  const double ratio = static_cast<double>(widest) / narrowest;
  for (int j = 0; j < kWidths; ++j) {
    widths[index(j)] =
        static_cast<float>(narrowest * std::pow(ratio, static_cast<double>(j) / (kWidths - 1)));
  }
  return widths;
}

}  // namespace

EvenPart findEvenPart(const LengthProblem& p, double narrowest, double leanCost,
                      LengthWorkspace& workspace) {
  const std::vector<float> widths = widthGrid(p, narrowest);
  // A chain over widths: both sides step by half a width, so its costs are doubled.
  LengthProblem chain;
  chain.ribs = p.ribs;
  chain.levels = kWidths;
  chain.neighbourWeight = 2 * p.neighbourWeight;
  chain.neighbourFreedom = p.neighbourFreedom;
  chain.neighbourCap = 2 * p.neighbourCap;
  chain.left.spacing = p.left.spacing;
  chain.left.unary.resize(index(p.ribs) * kWidths);
  for (int i = 0; i < p.ribs; ++i) {
    for (int j = 0; j < kWidths; ++j) chain.left.place.push_back(0.5f * widths[index(j)]);
  }
  EvenPart best;
  const auto tryLean = [&](double lean) {
    const auto left = static_cast<float>((1 + lean) / 2),
               right = static_cast<float>((1 - lean) / 2);
    std::fill(chain.left.unary.begin(), chain.left.unary.end(),
              static_cast<float>(leanCost * std::abs(lean)));
    for (int i = 0; i < p.ribs; ++i) {
      float* costs = &chain.left.unary[index(i) * kWidths];
      addSide(p, p.left, i, left, widths, costs);
      addSide(p, p.right, i, right, widths, costs);
    }
    const std::vector<int> labels = optimalSide(chain, chain.left, workspace);
    const double energy = sideEnergy(chain, chain.left, labels);
    if (!best.width.empty() && energy >= best.energy) return;
    best.energy = energy;
    best.lean = lean;
    best.width.clear();
    for (int label : labels) best.width.push_back(widths[index(label)]);
  };
  double step = kMostLean / kLeans;
  for (int i = 0; i <= kLeans; ++i) {
    tryLean(i * step);
    if (i > 0) tryLean(-i * step);
  }
  for (int round = 0; round < kRefinements; ++round) {
    step /= 2;
    const double middle = best.lean;
    if (middle + step <= kMostLean) tryLean(middle + step);
    if (middle - step >= -kMostLean) tryLean(middle - step);
  }
  return best;
}

}  // namespace spineloft::ribs
