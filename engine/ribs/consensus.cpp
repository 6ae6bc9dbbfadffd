#include "engine/ribs/consensus.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/ribs/other_hands.h"
#include "engine/ribs/outline_crossing.h"
#include "engine/ribs/rib_search.h"

namespace spineloft::ribs {
namespace {

// Fewer ribs than this have no width that a hand could wander by.
constexpr int kFewestRibs = 4;
// Other hands are searched for with at most so many ribs, those that the weights are meant for.
constexpr int kMostRibs = 100;
// The part that stands apart from the others counts for little: its mean agreement, to this power.
constexpr double kAgreementPower = 3;

// What one hand found: how far every curve of the stroke's own search lies within it, and how its ends are shaped.
struct Opinion {
  std::vector<float> lengths;
  std::array<EndShape, 2> shapes;
  double weight = 1;
};

Opinion opinionOf(const RibSet& part, const Search& of, const Search& own) {
  return {lengthsWithin(outlineOf(part), own.curves), of.shapes};
}

// 0 (nothing in common) … 1.
double agreement(const std::vector<float>& a, const std::vector<float>& b) {
  double shared = 0, all = 0;
  for (std::size_t c = 0; c < a.size(); ++c) {
    shared += static_cast<double>(std::min(a[c], b[c]));
    all += static_cast<double>(std::max(a[c], b[c]));
  }
  return all > 0 ? shared / all : 1;
}

void weigh(std::vector<Opinion>& opinions) {
  for (Opinion& one : opinions) {
    double sum = 0;
    for (const Opinion& other : opinions) sum += agreement(one.lengths, other.lengths);
    // All but what it agrees with itself.
    const double others = std::max(1.0, static_cast<double>(opinions.size()) - 1);
    one.weight = std::pow((sum - 1) / others, kAgreementPower);
  }
}

double totalWeight(const std::vector<Opinion>& opinions) {
  double total = 0;
  for (const Opinion& one : opinions) total += one.weight;
  return total;
}

// The length by which half of the weight has been left behind, of every curve.
std::vector<float> medianLengths(const std::vector<Opinion>& opinions) {
  const double half = totalWeight(opinions) / 2;
  std::vector<float> medians;
  std::vector<std::pair<float, double>> of;
  for (std::size_t c = 0; c < opinions.front().lengths.size(); ++c) {
    of.clear();
    for (const Opinion& one : opinions) of.emplace_back(one.lengths[c], one.weight);
    std::ranges::sort(of);
    std::size_t i = 0;
    for (double sum = of[0].second; sum < half && i + 1 < of.size(); sum += of[i].second) ++i;
    medians.push_back(of[i].first);
  }
  return medians;
}

// The shape that most of the weight gives an end.
EndShape shapeOfMost(const std::vector<Opinion>& opinions, bool atStart) {
  std::array<double, 3> weights{};
  for (const Opinion& one : opinions) weights[static_cast<std::size_t>(one.shapes[atStart ? 0 : 1])] += one.weight;
  const auto most = std::ranges::max_element(weights);
  return static_cast<EndShape>(most - weights.begin());
}

// What the other hands find, in the memory of `other`; those whose stroke makes no spine are left out.
Status askOthers(const PictureEvidence& picture, const RibSet& own, const Search& s, const Progress& progress,
                 Search& other, std::vector<Opinion>& opinions) {
  SpineParams even;
  even.ribs = std::min(s.problem.ribs, kMostRibs);
  even.minSpacing = 0.1;
  even.smoothness = 0;
  RibSet found;
  double done = 1;
  for (const OtherHand& hand : kOtherHands) {
    if (!progress.advance(done++ / (kOtherHands.size() + 1))) return Error::Cancelled;
    const Result<Spine> spine = cleanSpine(strokeOf(hand, own), picture.size, even);
    if (!spine) continue;
    other.variant = s.variant;
    if (!searchLabels(spine.value(), picture, s.params, Progress(), other).ok()) continue;
    readRibs(false, other, found);
    opinions.push_back(opinionOf(found, other, s));
  }
  return Done{};
}

}  // namespace

Result<RibSet> agreedRibs(const Spine& spine, const PictureEvidence& picture, const RibParams& params,
                          const Progress& progress, TraceVariant variant, RibWorkspace& memory) {
  Search& s = memory.search();
  s.variant = variant;
  RibSet set;
  if (picture.edges.empty() || variant.alone || spine.points.size() < kFewestRibs) {
    const Status found = searchRibs(spine, picture, params, progress, s, set);
    if (!found.ok()) return found.failure();
    return set;
  }
  const Status found = searchLabels(spine, picture, params, Progress(), s);
  if (!found.ok()) return found.failure();
  readRibs(false, s, set);
  std::vector<Opinion> opinions{opinionOf(set, s, s)};
  const Status asked = askOthers(picture, set, s, progress, memory.other(), opinions);
  if (!asked.ok()) return asked.failure();
  weigh(opinions);
  readRibsAt(medianLengths(opinions), {shapeOfMost(opinions, true), shapeOfMost(opinions, false)}, s, set);
  if (!progress.advance(1)) return Error::Cancelled;
  return set;
}

Result<RibSet> agreedRibs(const Spine& spine, const PictureEvidence& picture, const RibParams& params,
                          const Progress& progress, RibWorkspace& memory) {
  return agreedRibs(spine, picture, params, progress, {}, memory);
}

}  // namespace spineloft::ribs
