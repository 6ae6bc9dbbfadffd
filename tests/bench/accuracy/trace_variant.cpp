#include "tests/bench/accuracy/trace_variant.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "engine/ribs/search/rib_search.h"
#include "tests/bench/accuracy/algorithm_one.h"

namespace spineloft::accuracy {
namespace {

using ribs::Search;

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
void sampledLabels(Search& s) {
  double least = std::numeric_limits<double>::infinity();
  for (const ribs::WidthHypothesis& part : s.parts.span()) {
    assumeWidth(part, s);
    s.trial = algorithmOne(s.problem, {});
    const double energy = energyOf(s.problem, s.trial).total();
    if (energy >= least) continue;
    least = energy;
    s.labels = s.trial;
  }
}

// searchLabels with stages exchanged.
Status searchVariant(const ribs::Spine& spine, const ribs::PictureEvidence& picture, const ribs::RibParams& params,
                     const TraceVariant& variant, Search& s) {
  if (Status begun = beginSearch(spine, picture, params, s); !begun.ok()) return begun;
  if (variant.euclidean) straighten(picture.size, s);
  unwrapImage(s.curves, picture.edges, picture.ignored, s.strip);
  findEvidence(s);
  fillProblem(s);
  fitWidthHypotheses(s);
  if (variant.sampled) {
    sampledLabels(s);
  } else {
    bestLabels(s);
  }
  return Done{};
}

}  // namespace

Result<ribs::RibSet> variantRibs(const ribs::Spine& spine, const ribs::PictureEvidence& picture,
                                 const ribs::RibParams& params, const TraceVariant& variant) {
  ribs::RibWorkspace memory;
  Search& s = memory.search();
  if (Status searched = searchVariant(spine, picture, params, variant, s); !searched.ok()) return searched.failure();
  ribs::RibSet found;
  readRibs(true, s, found);
  return found;
}

}  // namespace spineloft::accuracy
