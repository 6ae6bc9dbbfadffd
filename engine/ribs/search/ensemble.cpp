#include "engine/ribs/search/ensemble.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/ribs/ends/outline_crossing.h"
#include "engine/ribs/search/perturbed_strokes.h"
#include "engine/ribs/search/rib_search.h"

namespace spineloft::ribs {
namespace {

// With fewer ribs there is no width to perturb a stroke by.
constexpr int kFewestRibs = 4;
// Most ribs of a perturbed stroke: the number for which the weights were chosen.
constexpr int kMostRibs = 100;
// The weight of a result is its mean agreement to this power, so that an outlier counts little.
constexpr double kAgreementPower = 3;

// One result: the length of every curve of the stroke's own search within the part found, and the shapes of its ends.
struct EnsembleVote {
  std::vector<float> lengths;
  std::array<EndShape, 2> shapes;
  double weight = 1;
};

EnsembleVote voteOf(const RibSet& part, const Search& of, const Search& own) {
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

void weigh(std::vector<EnsembleVote>& votes) {
  for (EnsembleVote& one : votes) {
    double sum = 0;
    for (const EnsembleVote& other : votes) sum += agreement(one.lengths, other.lengths);
    // The agreement of a result with itself is 1 and does not count.
    const double others = std::max(1.0, static_cast<double>(votes.size()) - 1);
    one.weight = std::pow((sum - 1) / others, kAgreementPower);
  }
}

double totalWeight(const std::vector<EnsembleVote>& votes) {
  double total = 0;
  for (const EnsembleVote& one : votes) total += one.weight;
  return total;
}

// The weighted median of the lengths, of every curve.
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

// The shape of an end with the largest total weight.
EndShape shapeOfMost(const std::vector<EnsembleVote>& votes, bool atStart) {
  std::array<double, 3> weights{};
  for (const EnsembleVote& one : votes) weights[static_cast<std::size_t>(one.shapes[atStart ? 0 : 1])] += one.weight;
  const auto most = std::ranges::max_element(weights);
  return static_cast<EndShape>(most - weights.begin());
}

}  // namespace

struct EnsembleTrace::State {
  Spine spine;
  RibParams params;
  TraceVariant variant;
  RibSet own, found;
  std::vector<EnsembleVote> votes;
  std::size_t asked = 0;  // perturbed strokes
  bool begun = false, done = false;
};

EnsembleTrace::EnsembleTrace(Spine spine, const RibParams& params, TraceVariant variant)
    : state_(std::make_unique<State>()) {
  state_->spine = std::move(spine);
  state_->params = params;
  state_->variant = variant;
}
EnsembleTrace::~EnsembleTrace() = default;
EnsembleTrace::EnsembleTrace(EnsembleTrace&&) noexcept = default;
EnsembleTrace& EnsembleTrace::operator=(EnsembleTrace&&) noexcept = default;

double EnsembleTrace::progress() const {
  return state_->done ? 1
                      : (state_->begun ? 1.0 + static_cast<double>(state_->asked) : 0) / (kPerturbedStrokes.size() + 1);
}

const RibSet& EnsembleTrace::ribs() const { return state_->own; }

Status EnsembleTrace::begin(const PictureEvidence& picture, RibWorkspace& memory) {
  State& a = *state_;
  Search& s = memory.search();
  s.variant = a.variant;
  a.begun = true;
  if (picture.edges.empty() || a.variant.alone || a.spine.points.size() < kFewestRibs) {
    a.done = true;
    return searchRibs(a.spine, picture, a.params, Progress(), s, a.own);
  }
  Status found = searchLabels(a.spine, picture, a.params, Progress(), s);
  if (!found.ok()) return found;
  readRibs(false, s, a.own);
  a.votes.push_back(voteOf(a.own, s, s));
  return Done{};
}

// A perturbed stroke that gives no valid spine is left out of the ensemble.
void EnsembleTrace::ask(const PictureEvidence& picture, RibWorkspace& memory) {
  State& a = *state_;
  Search &s = memory.search(), &other = memory.other();
  SpineParams even;
  even.ribs = std::min(s.problem.ribs, kMostRibs);
  even.minSpacing = 0.1;
  even.smoothness = 0;
  const Result<Spine> spine = cleanSpine(strokeOf(kPerturbedStrokes[a.asked++], a.own), picture.size, even);
  if (!spine) return;
  other.variant = a.variant;
  if (!searchLabels(spine.value(), picture, a.params, Progress(), other).ok()) return;
  readRibs(false, other, a.found);
  a.votes.push_back(voteOf(a.found, other, s));
}

Result<bool> EnsembleTrace::step(const PictureEvidence& picture, RibWorkspace& memory) {
  State& a = *state_;
  if (!a.begun) {
    const Status begun = begin(picture, memory);
    a.done = a.done || !begun.ok();
    if (!begun.ok()) return begun.failure();
    return !a.done;
  }
  if (a.done) return false;
  if (a.asked < kPerturbedStrokes.size()) ask(picture, memory);
  if (a.asked < kPerturbedStrokes.size()) return true;
  weigh(a.votes);
  readRibsAt(withoutSpikes(medianLengths(a.votes), memory.search().curves.layout),
             {shapeOfMost(a.votes, true), shapeOfMost(a.votes, false)}, memory.search(), a.own);
  a.done = true;
  return false;
}

Result<RibSet> ensembleRibs(const Spine& spine, const PictureEvidence& picture, const RibParams& params,
                            const Progress& progress, TraceVariant variant, RibWorkspace& memory) {
  EnsembleTrace agreement(spine, params, variant);
  while (true) {
    const Result<bool> more = agreement.step(picture, memory);
    if (!more) return more.failure();
    if (!progress.advance(agreement.progress())) return Error::Cancelled;
    if (!more.value()) return agreement.ribs();
  }
}

Result<RibSet> ensembleRibs(const Spine& spine, const PictureEvidence& picture, const RibParams& params,
                            const Progress& progress, RibWorkspace& memory) {
  return ensembleRibs(spine, picture, params, progress, {}, memory);
}

}  // namespace spineloft::ribs
