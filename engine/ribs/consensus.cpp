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

}  // namespace

struct RibAgreement::State {
  Spine spine;
  RibParams params;
  TraceVariant variant;
  RibSet own, found;
  std::vector<Opinion> opinions;
  std::size_t asked = 0;  // other hands
  bool begun = false, done = false;
};

RibAgreement::RibAgreement(Spine spine, const RibParams& params, TraceVariant variant)
    : state_(std::make_unique<State>()) {
  state_->spine = std::move(spine);
  state_->params = params;
  state_->variant = variant;
}
RibAgreement::~RibAgreement() = default;
RibAgreement::RibAgreement(RibAgreement&&) noexcept = default;
RibAgreement& RibAgreement::operator=(RibAgreement&&) noexcept = default;

double RibAgreement::progress() const {
  return state_->done ? 1 : (state_->begun ? 1.0 + static_cast<double>(state_->asked) : 0) / (kOtherHands.size() + 1);
}

const RibSet& RibAgreement::ribs() const { return state_->own; }

Status RibAgreement::begin(const PictureEvidence& picture, RibWorkspace& memory) {
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
  a.opinions.push_back(opinionOf(a.own, s, s));
  return Done{};
}

// A hand whose stroke makes no spine has no opinion.
void RibAgreement::ask(const PictureEvidence& picture, RibWorkspace& memory) {
  State& a = *state_;
  Search &s = memory.search(), &other = memory.other();
  SpineParams even;
  even.ribs = std::min(s.problem.ribs, kMostRibs);
  even.minSpacing = 0.1;
  even.smoothness = 0;
  const Result<Spine> spine = cleanSpine(strokeOf(kOtherHands[a.asked++], a.own), picture.size, even);
  if (!spine) return;
  other.variant = a.variant;
  if (!searchLabels(spine.value(), picture, a.params, Progress(), other).ok()) return;
  readRibs(false, other, a.found);
  a.opinions.push_back(opinionOf(a.found, other, s));
}

Result<bool> RibAgreement::step(const PictureEvidence& picture, RibWorkspace& memory) {
  State& a = *state_;
  if (!a.begun) {
    const Status begun = begin(picture, memory);
    a.done = a.done || !begun.ok();
    if (!begun.ok()) return begun.failure();
    return !a.done;
  }
  if (a.done) return false;
  if (a.asked < kOtherHands.size()) ask(picture, memory);
  if (a.asked < kOtherHands.size()) return true;
  weigh(a.opinions);
  readRibsAt(withoutSpikes(medianLengths(a.opinions), memory.search().curves.layout), {shapeOfMost(a.opinions, true), shapeOfMost(a.opinions, false)},
             memory.search(), a.own);
  a.done = true;
  return false;
}

Result<RibSet> agreedRibs(const Spine& spine, const PictureEvidence& picture, const RibParams& params,
                          const Progress& progress, TraceVariant variant, RibWorkspace& memory) {
  RibAgreement agreement(spine, params, variant);
  while (true) {
    const Result<bool> more = agreement.step(picture, memory);
    if (!more) return more.failure();
    if (!progress.advance(agreement.progress())) return Error::Cancelled;
    if (!more.value()) return agreement.ribs();
  }
}

Result<RibSet> agreedRibs(const Spine& spine, const PictureEvidence& picture, const RibParams& params,
                          const Progress& progress, RibWorkspace& memory) {
  return agreedRibs(spine, picture, params, progress, {}, memory);
}

}  // namespace spineloft::ribs
