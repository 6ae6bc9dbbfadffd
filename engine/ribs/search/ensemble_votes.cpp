#include "engine/ribs/search/ensemble_votes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/ribs/ends/outline_crossing.h"

namespace spineloft::ribs {
namespace {

// Fewer ribs than this have no width that a hand could wander by.
constexpr std::size_t kFewestRibs = 4;
// Perturbed strokes are searched with at most so many ribs, those that the weights are meant for.
constexpr int kMostRibs = 100;
// The part that stands apart from the others counts for little: its mean agreement, to this power.
constexpr double kAgreementPower = 3;

// 0 (nothing in common) … 1.
double agreement(const std::vector<float>& a, const std::vector<float>& b) {
  double shared = 0, all = 0;
  for (std::size_t c = 0; c < a.size(); ++c) {
    shared += static_cast<double>(std::min(a[c], b[c]));
    all += static_cast<double>(std::max(a[c], b[c]));
  }
  return all > 0 ? shared / all : 1;
}

void weigh(std::vector<EnsembleVote>& votes) {
  for (EnsembleVote& one : votes) {
    double sum = 0;
    for (const EnsembleVote& other : votes) sum += agreement(one.lengths, other.lengths);
    // All but what it agrees with itself.
    const double others = std::max(1.0, static_cast<double>(votes.size()) - 1);
    one.weight = std::pow((sum - 1) / others, kAgreementPower);
  }
}

double totalWeight(const std::vector<EnsembleVote>& votes) {
  double total = 0;
  for (const EnsembleVote& one : votes) total += one.weight;
  return total;
}

// The length by which half of the weight has been left behind, of every curve.
std::vector<float> medianLengths(const std::vector<EnsembleVote>& votes) {
  const double half = totalWeight(votes) / 2;
  std::vector<float> medians;
  std::vector<std::pair<float, double>> of;
  for (std::size_t c = 0; c < votes.front().lengths.size(); ++c) {
    of.clear();
    for (const EnsembleVote& one : votes) of.emplace_back(one.lengths[c], one.weight);
    std::ranges::sort(of);
    std::size_t i = 0;
    for (double sum = of[0].second; sum < half && i + 1 < of.size(); sum += of[i].second) ++i;
    medians.push_back(of[i].first);
  }
  return medians;
}

// The shape that most of the weight gives an end.
EndShape shapeOfMost(const std::vector<EnsembleVote>& votes, bool atStart) {
  std::array<double, 3> weights{};
  for (const EnsembleVote& one : votes) weights[static_cast<std::size_t>(one.shapes[atStart ? 0 : 1])] += one.weight;
  const auto most = std::ranges::max_element(weights);
  return static_cast<EndShape>(most - weights.begin());
}

}  // namespace

bool hasEnsemble(const Spine& spine, const PictureEvidence& picture) {
  return !picture.edges.empty() && spine.points.size() >= kFewestRibs;
}

Result<Spine> perturbedSpine(const PerturbedStroke& stroke, const RibSet& own, image::Size picture) {
  SpineParams even;
  even.ribs = std::min(static_cast<int>(own.ribs.size()), kMostRibs);
  even.minSpacing = 0.1;
  even.smoothness = 0;
  return cleanSpine(strokeOf(stroke, own), picture, even);
}

EnsembleVote voteOf(const RibSet& part, const Search& of, const Search& own) {
  return {lengthsWithin(outlineOf(part), own.curves), of.shapes};
}

void readVotes(std::vector<EnsembleVote>& votes, Search& own, RibSet& set) {
  weigh(votes);
  readRibsAt(withoutSpikes(medianLengths(votes), own.curves.layout),
             {shapeOfMost(votes, true), shapeOfMost(votes, false)}, own, set);
}

}  // namespace spineloft::ribs
