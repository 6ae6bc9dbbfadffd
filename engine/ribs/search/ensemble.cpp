#include "engine/ribs/search/ensemble.h"

#include <algorithm>
#include <utility>

#include "engine/ribs/search/ensemble_votes.h"
#include "engine/ribs/search/perturbed_strokes.h"
#include "engine/ribs/search/rib_search.h"

namespace spineloft::ribs {

struct EnsembleTrace::State {
  Spine spine;
  RibParams params;
  RibSet own, found;
  std::vector<EnsembleVote> votes;
  std::size_t asked = 0;  // perturbed strokes
  bool begun = false, done = false;
};

EnsembleTrace::EnsembleTrace(Spine spine, const RibParams& params) : state_(std::make_unique<State>()) {
  state_->spine = std::move(spine);
  state_->params = params;
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
  a.begun = true;
  if (!hasEnsemble(a.spine, picture)) {
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
  const Result<Spine> spine = perturbedSpine(kPerturbedStrokes[a.asked++], a.own, picture.size);
  if (!spine) return;
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
  readVotes(a.votes, memory.search(), a.own);
  a.done = true;
  return false;
}

Result<RibSet> ensembleRibs(const Spine& spine, const PictureEvidence& picture, const RibParams& params,
                            const Progress& progress, RibWorkspace& memory) {
  EnsembleTrace trace(spine, params);
  while (true) {
    const Result<bool> more = trace.step(picture, memory);
    if (!more) return more.failure();
    if (!progress.advance(trace.progress())) return Error::Cancelled;
    if (!more.value()) return trace.ribs();
  }
}

}  // namespace spineloft::ribs
