// Where every curve leaves the object, by the network: probabilities, and the costs that the search is made with
// (method: "Where is the boundary?").
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/ribs/base/rib_params.h"
#include "engine/ribs/learned/network.h"

namespace spineloft::ribs {

/// Memory of findBoundary.
struct BoundaryScratch {
  ColourTables colours;
  std::vector<float> logOdds;
  ChannelScratch channels;
  StripChannels strip;
  NetworkScratch network;
  std::array<std::vector<float>, 2> scores;
};

/// Of every curve, fans included, and label: curves × levels.
struct Boundary {
  std::vector<float> chance;       ///< probability that the curve leaves the object at the label; a curve's sum to 1
  std::vector<float> support;      ///< probability that it does so there or close by, 0…1
  std::vector<std::uint8_t> seen;  ///< 1 where the picture shows an edge there or close by that is not ignored
  std::vector<float> costs;  ///< −log(chance + doubt), relative to an even spread over three sixteenths of the labels
  BoundaryScratch scratch;

  /// Nothing is known of any of `count` entries.
  void clear(std::size_t count) {
    chance.assign(count, 0.f);
    support.assign(count, 0.f);
    seen.assign(count, 0);
    costs.assign(count, 0.f);
  }
  /// Whether an end at the entry stands on an edge of the picture: one is seen, and it is more likely the part's than
  /// not.
  [[nodiscard]] bool isOnEdge(std::size_t at) const { return seen[at] != 0 && support[at] >= 0.5f; }
};

/// Scores of every curve and label: a softmax along a curve gives the probability that the part ends there. The colours
/// of `scratch` are sorted. Replaces `scores`.
void learnedScores(const RibNetwork& network, const GradientCurves& curves, const UnwrappedImage& strip,
                   BoundaryScratch& scratch, std::vector<float>& scores);

/// Fills `boundary` from a strip sampled along `curves`. Without a network nearness to an edge has to do.
void findBoundary(const GradientCurves& curves, const UnwrappedImage& strip, const RibNetwork* network,
                  const EvidenceParams& params, Boundary& boundary);

/// The share of the probability that lies where the picture shows an edge, 0…1.
double shownShare(const Boundary& boundary);

/// Costs as if `share` of the probability of every curve were `prior`, a probability of each level. The others of
/// `boundary` stay.
void mixPrior(const GradientCurves& curves, std::span<const float> prior, double share, const EvidenceParams& params,
              Boundary& boundary);

}  // namespace spineloft::ribs
