#include "tests/bench/accuracy/variations.h"

#include <algorithm>
#include <vector>

namespace spineloft::accuracy {
namespace {

using ribs::EvidenceParams;
using ribs::RibParams;

/// The product with one weight of the evidence at 0.
Variation without(double EvidenceParams::* weight, std::string_view key, std::string_view title) {
  Variation out{key, title, {}, {}};
  out.params.evidence.*weight = 0;
  return out;
}

/// Every curve to itself: its own best label.
RibParams separate() {
  RibParams params;
  params.neighbourWeight = params.oppositeWeight = 0;
  params.fairing.stiffness = 0;
  return params;
}

/// Nearness to a Canny edge alone, as in the paper.
RibParams edgesAlone() {
  RibParams params;
  EvidenceParams& e = params.evidence;
  e.contrastWeight = e.localContrastWeight = e.beyondWeight = 0;
  e.insideWeight = e.outsideWeight = 0;
  e.knownShare = e.rimWeight = 0;
  return params;
}

std::vector<Variation> listed() {
  std::vector<Variation> all{
      {"product", "as it is", {}, {}},
      {"d-inf", "d-infinity (Euclidean distance) instead of d2", {}, {.euclidean = true}},
      {"separate", "no optimisation: every end to itself", separate(), {}},
      {"d-inf-separate", "d-infinity and no optimisation", separate(), {.euclidean = true}},
      {"algorithm-1", "the paper's Algorithm 1 instead of the optimum", {}, {.sampled = true}},
      {"edges-alone", "the paper's evidence: nearness to an edge alone", edgesAlone(), {}},
      {"edges-algorithm-1",
       "the paper's evidence and its Algorithm 1, without other hands",
       edgesAlone(),
       {.sampled = true, .alone = true}},
      without(&EvidenceParams::proximityWeight, "no-edges", "without nearness to an edge"),
      without(&EvidenceParams::contrastWeight, "no-contrast", "without contrast along the contour"),
      without(&EvidenceParams::localContrastWeight, "no-local", "without contrast against what is near"),
      without(&EvidenceParams::beyondWeight, "no-beyond", "without edges further out"),
      without(&EvidenceParams::insideWeight, "no-inside", "without colours inside"),
      without(&EvidenceParams::outsideWeight, "no-outside", "without colours outside"),
      without(&EvidenceParams::knownShare, "no-second-look", "without a second look at the colours"),
      without(&EvidenceParams::rimWeight, "no-third-look", "without a third look at the colours"),
      {"no-farther", "without a look beyond the part", {}, {.nearest = true}},
      {"alone", "without asking other hands", {}, {.alone = true}}};
  Variation shape{"no-neighbours", "without the neighbour term", {}, {}};
  shape.params.neighbourWeight = 0;
  all.push_back(shape);
  shape = {"no-opposite", "without the opposite term", {}, {}};
  shape.params.oppositeWeight = 0;
  all.push_back(shape);
  shape = {"no-fairing", "without fairing", {}, {}};
  shape.params.fairing.stiffness = 0;
  all.push_back(shape);
  return all;
}

}  // namespace

std::span<const Variation> variations() {
  static const std::vector<Variation> kAll = listed();
  return kAll;
}

const Variation* variationFromKey(std::string_view key) {
  const auto all = variations();
  const auto at = std::ranges::find(all, key, &Variation::key);
  return at == all.end() ? nullptr : &*at;
}

}  // namespace spineloft::accuracy
