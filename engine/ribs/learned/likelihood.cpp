#include "engine/ribs/learned/likelihood.h"

#include <algorithm>

#include "engine/base/lanes.h"

namespace spineloft::ribs {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// Ribs lie between rows: their scores are interpolated.
void spreadOverRibs(const CurveLayout& layout, const StripChannels& strip,
                    const std::array<std::vector<float>, 2>& scores, int levels, std::vector<float>& out) {
  const int along = stripRows(layout.ribs, levels), before = (strip.rows - along) / 2;
  for (int i = 0; i < layout.ribs; ++i) {
    const int j = strip.reversed ? layout.ribs - 1 - i : i;
    const float place =
        (static_cast<float>(j) + 0.5f) * static_cast<float>(along) / static_cast<float>(layout.ribs) - 0.5f;
    const float at = std::clamp(place, 0.f, static_cast<float>(along - 1));
    const int first = static_cast<int>(at), second = std::min(first + 1, along - 1);
    const float share = at - static_cast<float>(first);
    for (const int side : {0, 1}) {
      const float* a = &scores[index(side)][index(before + first) * index(strip.levels)];
      const float* b = &scores[index(side)][index(before + second) * index(strip.levels)];
      float* to = &out[index(layout.sideOf(i, side == 0)) * index(levels)];
      for (int k = 0; k < levels; ++k) to[k] = a[k] + share * (b[k] - a[k]);
    }
  }
}

// The middle curve of a fan belongs to both sides.
void copyFans(const StripChannels& strip, const std::array<std::vector<float>, 2>& scores, int levels,
              std::vector<float>& out) {
  for (int r = 0; r < strip.rows; ++r) {
    const StripRow &left = strip.sources[0][index(r)], &right = strip.sources[1][index(r)];
    if (!left.fan) continue;
    const float* a = &scores[0][index(r) * index(strip.levels)];
    const float* b = &scores[1][index(r) * index(strip.levels)];
    float *ofLeft = &out[index(left.first) * index(levels)], *ofRight = &out[index(right.first) * index(levels)];
    const bool shared = left.first == right.first;
    for (int k = 0; k < levels; ++k) {
      ofLeft[k] = shared ? 0.5f * (a[k] + b[k]) : a[k];
      if (!shared) ofRight[k] = b[k];
    }
  }
}

// The share of a curve's labels over which an even spread costs nothing.
constexpr float kEvenShare = 3.f / 16;
// One label for so many on either side is close by.
constexpr int kCloseLabels = 64;
// What nearness to an edge counts for where there is no network.
constexpr float kNearnessAlone = 2.2f;

// Less than this near to an edge of the picture counts as on none.
constexpr float kNearEdge = 0.3f;

// Whether the picture shows an edge at one of `count` entries from `first` on: what is likely on no evidence, behind
// something else say, is bridged or a guess.
bool showsEdge(const float* proximity, std::size_t first, std::size_t count) {
  return std::any_of(proximity + first, proximity + first + count, [](float near) { return near >= kNearEdge; });
}

// Scores of one curve to probabilities, in place.
void softmax(float* values, std::size_t count) {
  float best = -1e9f, sum = 0;
  for (std::size_t k = 1; k < count; ++k) best = values[k] > best ? values[k] : best;
  for (std::size_t k = 1; k < count; ++k) values[k] = quickExp(values[k] - best);
  for (std::size_t k = 1; k < count; ++k) sum += values[k];
  const float share = 1 / sum;
  for (std::size_t k = 1; k < count; ++k) values[k] *= share;
}

}  // namespace

void learnedScores(const RibNetwork& network, const GradientCurves& curves, const UnwrappedImage& strip,
                   BoundaryScratch& s, std::vector<float>& scores) {
  fillChannels(curves, strip, s.colours, s.logOdds, s.channels, s.strip);
  network.run(s.strip, s.network, s.scores);
  scores.resize(curves.x.size());
  spreadOverRibs(curves.layout, s.strip, s.scores, curves.levels, scores);
  copyFans(s.strip, s.scores, curves.levels, scores);
}

void findBoundary(const GradientCurves& curves, const UnwrappedImage& strip, const RibNetwork* network,
                  const EvidenceParams& params, Boundary& b) {
  const bool learned = network && params.learnedWeight > 0;
  sortColours(curves, strip, b.scratch.colours);
  b.clear(curves.x.size());
  if (learned) learnedScores(*network, curves, strip, b.scratch, b.chance);
  const auto ofNetwork = static_cast<float>(params.learnedWeight), doubt = static_cast<float>(params.doubt);
  const float near = learned ? static_cast<float>(params.proximityWeight) : kNearnessAlone;
  const float even = kEvenShare * static_cast<float>(strip.levels);
  const std::size_t close = index((strip.levels + kCloseLabels / 2) / kCloseLabels);
  for (int c = 0; c < strip.curves; ++c) {
    const std::size_t row = curves.at(c, 0);
    const auto reached = index(curves.reached[index(c)]);
    float *chance = &b.chance[row], *support = &b.support[row], *costs = &b.costs[row];
    const float* proximity = &strip.proximity[row];
    for (std::size_t k = 1; k < reached; ++k) chance[k] = ofNetwork * chance[k] + near * proximity[k];
    softmax(chance, reached);
    chance[0] = 0;
    std::fill(chance + reached, chance + curves.levels, 0.f);
    for (std::size_t k = 1; k < reached; ++k) costs[k] = -quickLog(chance[k] * even + doubt);
    float sum = 0;
    for (std::size_t k = 1; k < std::min(reached, 1 + close); ++k) sum += chance[k];
    for (std::size_t k = 1; k < reached; ++k) {
      if (k + close < reached) sum += chance[k + close];
      if (k > close) sum -= chance[k - close - 1];
      const std::size_t first = k - std::min(k, close), last = std::min(reached - 1, k + close);
      support[k] = std::clamp(sum, 0.f, 1.f);
      b.seen[row + k] = !strip.isIgnored(row + k) && showsEdge(proximity, first, last + 1 - first);
    }
  }
}

double shownShare(const Boundary& b) {
  double shown = 0, all = 0;
  for (std::size_t i = 0; i < b.chance.size(); ++i) {
    all += static_cast<double>(b.chance[i]);
    if (b.seen[i] != 0) shown += static_cast<double>(b.chance[i]);
  }
  return all > 0 ? shown / all : 0;
}

void mixPrior(const GradientCurves& curves, std::span<const float> prior, double share, const EvidenceParams& params,
              Boundary& b) {
  const float even = kEvenShare * static_cast<float>(curves.levels), doubt = static_cast<float>(params.doubt);
  const auto ofPrior = static_cast<float>(share), ofPicture = 1 - ofPrior;
  for (std::size_t row = 0; row < b.chance.size(); row += prior.size()) {
    for (std::size_t k = 0; k < prior.size(); ++k) {
      b.costs[row + k] = -quickLog((ofPicture * b.chance[row + k] + ofPrior * prior[k]) * even + doubt);
    }
  }
}

}  // namespace spineloft::ribs
