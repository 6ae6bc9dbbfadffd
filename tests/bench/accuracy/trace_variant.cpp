#include "tests/bench/accuracy/trace_variant.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "engine/ribs/search/ensemble_votes.h"
#include "engine/ribs/search/rib_search.h"
#include "tests/bench/accuracy/algorithm_one.h"

namespace spineloft::accuracy {
namespace {

using ribs::Search;

constexpr double kAnywhere = std::numeric_limits<double>::infinity();

// Gradient curves of the Euclidean distance d∞ in place of those of d2: straight lines through the same seeds, along
// the normals and around the ends. They stop where another part of the spine is nearer, for there d∞ has no gradient.
// Labels stand for distances.
void straighten(image::Size picture, Search& s) {
  // How much nearer another part may be, as a share, before the medial axis is taken to be crossed.
  constexpr double kNearer = 0.99;
  ribs::GradientCurves& curves = s.curves;
  for (std::size_t c = 0; c < curves.seeds.size(); ++c) {
    const PicturePoint base = curves.seeds[c][0], out = normalized(curves.seeds[c][1] - base);
    int k = 0;
    for (; k < curves.levels; ++k) {
      const double radius = s.levels.radius[static_cast<std::size_t>(k)];
      const PicturePoint p = base + out * radius;
      const bool inFrame = p.x >= -0.5 && p.y >= -0.5 && p.x <= picture.width - 0.5 && p.y <= picture.height - 0.5;
      const auto nearer = [&](PicturePoint q) { return distance(p, q) < kNearer * radius; };
      if (k > 0 && (!inFrame || std::ranges::any_of(s.spine.points, nearer))) break;
      const std::size_t at = curves.at(static_cast<int>(c), k);
      curves.x[at] = static_cast<float>(p.x);
      curves.y[at] = static_cast<float>(p.y);
      curves.along[at] = static_cast<float>(radius);
    }
    curves.reached[c] = k;
  }
}

// bestLabels, by Algorithm 1.
void sampledLabels(bool withColours, Search& s) {
  s.contest = {};
  for (std::size_t i = 0; i < s.parts.count; ++i) {
    adoptHypothesis(i, withColours, s);
    s.trial = algorithmOne(s.problem, {});
    const double energy = energyOf(s.problem, s.trial).total();
    if (energy >= s.contest.least) continue;
    s.contest.least = energy;
    s.contest.chosen = i;
    s.labels = s.trial;
  }
  if (s.contest.last != s.contest.chosen) adoptHypothesis(s.contest.chosen, withColours, s);
}

// searchLabels with stages exchanged.
Status searchVariant(const ribs::Spine& spine, const ribs::PictureEvidence& picture, const ribs::RibParams& params,
                     const TraceVariant& variant, Search& s) {
  if (Status begun = beginSearch(spine, picture, params, kAnywhere, s); !begun.ok()) return begun;
  if (variant.euclidean) straighten(picture.size, s);
  unwrapImage(s.curves, picture.edges, picture.ignored, s.strip);
  findContours(s);
  firstEvidence(s);
  fillProblem(s);
  fitWidthHypotheses(s);
  const bool withColours = usesColours(picture, params);
  if (variant.sampled) {
    sampledLabels(withColours, s);
    return Done{};
  }
  bestLabels(withColours, s);
  if (withColours && !variant.nearest) tryOuterHypothesis(s);
  if (!withColours || !(params.evidence.rimWeight > 0)) return Done{};
  stiffLengths(s);
  thirdEvidence(s);
  findLabels(s.problem, kAnywhere, s.workspace, s.labels);
  return Done{};
}

}  // namespace

Result<ribs::RibSet> variantRibs(const ribs::Spine& spine, const ribs::PictureEvidence& picture,
                                 const ribs::RibParams& params, const TraceVariant& variant) {
  ribs::RibWorkspace memory;
  Search &s = memory.search(), &other = memory.other();
  ribs::RibSet own, found;
  if (Status searched = searchVariant(spine, picture, params, variant, s); !searched.ok()) return searched.failure();
  const bool alone = variant.alone || !hasEnsemble(spine, picture);
  readRibs(alone, s, own);
  if (alone) return own;
  std::vector<ribs::EnsembleVote> votes{voteOf(own, s, s)};
  for (const ribs::PerturbedStroke& stroke : ribs::kPerturbedStrokes) {
    const Result<ribs::Spine> perturbed = perturbedSpine(stroke, own, picture.size);
    if (!perturbed || !searchVariant(perturbed.value(), picture, params, variant, other).ok()) continue;
    readRibs(false, other, found);
    votes.push_back(voteOf(found, other, s));
  }
  readVotes(votes, s, own);
  return own;
}

}  // namespace spineloft::accuracy
