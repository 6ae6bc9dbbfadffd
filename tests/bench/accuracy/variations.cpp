#include "tests/bench/accuracy/variations.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace spineloft::accuracy {
namespace {

using ribs::EvidenceParams;
using ribs::RibParams;

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
  params.evidence.learnedWeight = 0;
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
      {"edges-algorithm-1", "the paper's evidence and its Algorithm 1", edgesAlone(), {.sampled = true}}};
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

bool setNumber(std::string_view keyAndValue, Variation& variation) {
  RibParams& p = variation.params;
  EvidenceParams& e = p.evidence;
  const std::pair<std::string_view, double*> numbers[]{{"proximityWeight", &e.proximityWeight},
                                                       {"learnedWeight", &e.learnedWeight},
                                                       {"doubt", &e.doubt},
                                                       {"weight", &e.weight},
                                                       {"neighbourWeight", &p.neighbourWeight},
                                                       {"neighbourFreedom", &p.neighbourFreedom},
                                                       {"neighbourCap", &p.neighbourCap},
                                                       {"oppositeWeight", &p.oppositeWeight},
                                                       {"medialOffsetCost", &p.medialOffsetCost},
                                                       {"stiffness", &p.fairing.stiffness}};
  const std::size_t equals = std::min(keyAndValue.find('='), keyAndValue.size());
  const auto* at = std::ranges::find(numbers, keyAndValue.substr(0, equals), [](const auto& n) { return n.first; });
  if (at == std::ranges::end(numbers) || equals + 1 >= keyAndValue.size()) return false;
  *at->second = std::atof(std::string(keyAndValue.substr(equals + 1)).c_str());
  return true;
}

}  // namespace spineloft::accuracy
