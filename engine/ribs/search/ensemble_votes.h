// What an ensemble's strokes find, and the ribs that most of them agree on. Internal to ribs/.
#pragma once

#include <array>
#include <vector>

#include "engine/ribs/search/perturbed_strokes.h"
#include "engine/ribs/search/rib_search.h"

namespace spineloft::ribs {

/// What one stroke found: how far every curve of the stroke's own search lies within it, and how its ends are shaped.
struct EnsembleVote {
  std::vector<float> lengths;
  std::array<EndShape, 2> shapes;
  double weight = 1;
};

/// Whether perturbed strokes can tell more than the stroke itself: with edges, and four ribs or more.
bool hasEnsemble(const Spine& spine, const PictureEvidence& picture);

/// The spine of a perturbed stroke through what the stroke itself found. Errors: those of cleanSpine.
Result<Spine> perturbedSpine(const PerturbedStroke& stroke, const RibSet& own, image::Size picture);

/// `part` as read from the search `of`, against the curves of the stroke's own search.
EnsembleVote voteOf(const RibSet& part, const Search& of, const Search& own);

/// Weighs the votes, the stroke's own among them, and reads into `set` the ribs that they give (ensemble.h).
void readVotes(std::vector<EnsembleVote>& votes, Search& own, RibSet& set);

}  // namespace spineloft::ribs
