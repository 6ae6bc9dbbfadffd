#include "engine/ribs/evidence/evidence.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/base/lanes.h"
#include "engine/base/sorted_window.h"

namespace spineloft::ribs {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// Sum of a plane over arc length along one curve; sum[k] covers levels 1 … k.
void integrate(const GradientCurves& curves, int curve, const float* plane, std::vector<float>& sum) {
  const int reached = curves.reached[index(curve)];
  const float* along = &curves.along[curves.at(curve, 0)];
  sum.resize(index(reached));
  float total = 0;
  sum[0] = 0;
  for (int k = 1; k < reached; ++k) {
    total += plane[k] * (along[k] - along[k - 1]);
    sum[index(k)] = total;
  }
}

// Largest contrast of every curve; kUnknown where it was ignored, so that others are not measured
// against it.
constexpr float kUnknown = -1;
void strongestContrasts(const GradientCurves& curves, const UnwrappedImage& strip, const std::vector<float>& contrast,
                        std::vector<float>& strongest) {
  strongest.assign(index(curves.layout.total()), 0.f);
  for (int c = 0; c < curves.layout.total(); ++c) {
    const int reached = curves.reached[index(c)];
    const float* row = &contrast[curves.at(c, 0)];
    float most = 0;
    for (int k = 1; k < reached; ++k) most = row[k] > most ? row[k] : most;
    for (int k = 1; k < reached && most == 0; ++k) {
      if (strip.isIgnored(curves.at(c, k))) most = kUnknown;
    }
    strongest[index(c)] = most;
  }
}

float median(std::vector<float>& values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Share of the curves' median strongest contrast that counts as a full edge, and the Lab
// differences below which nothing is believed to be one, in the whole strip and near by.
constexpr float kFullEdge = 0.7f, kLeastContrast = 2.f, kLeastLocalContrast = 3.5f;
// Curves to either side that "near by" means.
constexpr int kNearby = 10;
// Half the width that an edge fills along a curve, and what is left out beyond it, in map pixels.
constexpr float kEdgeExtent = 4.f;
// How far the rim reaches to either side, as a share of the way from the spine.
constexpr float kRim = 0.2f;
// What colours farther outside count for one that is just outside.
constexpr float kOuter = 0.85f;
// The share of a curve's labels over which an even spread costs nothing.
constexpr float kHypothesisShare = 3.f / 16;

void normalise(const GradientCurves& curves, const UnwrappedImage& strip, BoundaryTerms& terms) {
  std::vector<float>& strongest = terms.scratch.strongest;
  std::vector<float>& window = terms.scratch.window;
  strongestContrasts(curves, strip, terms.contrast, strongest);
  window = strongest;
  std::erase(window, kUnknown);
  const float scale = std::max(kLeastContrast, kFullEdge * median(window));
  const int total = curves.layout.total();
  terms.localContrast.assign(terms.contrast.size(), 0.f);
  // The curves are a ring around the spine.
  const auto strongestOf = [&](int c) { return strongest[index((c % total + total) % total)]; };
  SortedWindow nearby(window);
  const auto come = [&](float contrast) {
    if (contrast != kUnknown) nearby.add(contrast);
  };
  for (int j = -kNearby; j < kNearby; ++j) come(strongestOf(j));
  for (int c = 0; c < total; ++c) {
    come(strongestOf(c + kNearby));
    const float middle = nearby.size() > 0 ? nearby.at((nearby.size() - 1) / 2) : 0.f;
    const float local = std::max(kLeastLocalContrast, kFullEdge * middle);
    if (const float first = strongestOf(c - kNearby); first != kUnknown) nearby.remove(first);
    const int reached = curves.reached[index(c)];
    float* contrast = &terms.contrast[curves.at(c, 0)];
    float* compared = &terms.localContrast[curves.at(c, 0)];
    for (int k = 1; k < reached; ++k) {
      const float own = contrast[k], there = own / local, all = own / scale;
      compared[k] = there < 1 ? there : 1.f;
      contrast[k] = all < 1 ? all : 1.f;
    }
  }
}

// The last level of a curve whose arc length is at most `length`, searched upwards from `from`.
int levelAt(const float* along, int reached, int from, float length) {
  while (from + 1 < reached && along[from + 1] <= length) ++from;
  return from;
}

// Up to where colours count as just outside of every place, and up to where as farther outside.
void placeOutside(const GradientCurves& curves, const UnwrappedImage& strip, EvidenceScratch& scratch) {
  scratch.half.resize(curves.x.size());
  scratch.far.resize(curves.x.size());
  const float margin = 2 * kEdgeExtent * static_cast<float>(strip.pixel);
  for (int c = 0; c < strip.curves; ++c) {
    const std::size_t row = curves.at(c, 0);
    const int reached = curves.reached[index(c)];
    const float* along = &curves.along[row];
    int half = 0, far = 0;
    for (int k = 1; k < reached; ++k) {
      half = levelAt(along, reached, half, 1.5f * along[k] + margin);
      far = levelAt(along, reached, far, 2.5f * along[k] + 2 * margin);
      scratch.half[row + index(k)] = static_cast<std::uint16_t>(half);
      scratch.far[row + index(k)] = static_cast<std::uint16_t>(far);
    }
  }
}

// The rim of one curve, from the sums of its novelty.
void rimOf(const GradientCurves& curves, const UnwrappedImage& strip, int c, const std::vector<float>& foreign,
           std::vector<float>& rim) {
  const std::size_t row = curves.at(c, 0);
  const int reached = curves.reached[index(c)];
  const float* along = &curves.along[row];
  const float least = kEdgeExtent * static_cast<float>(strip.pixel);
  rim[row] = 0;
  int in = 0, out = 0;
  for (int k = 1; k < reached; ++k) {
    const float breadth = std::max(least, kRim * along[k]);
    in = std::min(levelAt(along, reached, in, along[k] - breadth), k - 1);
    out = levelAt(along, reached, std::max(out, k), along[k] + breadth);
    const auto mean = [&](int from, int to) {
      return (foreign[index(to)] - foreign[index(from)]) / (along[to] - along[from]);
    };
    rim[row + index(k)] = (out > k ? mean(k, out) : 0.f) - mean(in, k);
  }
  std::fill(&rim[row] + reached, &rim[row] + curves.levels, 0.f);
}

}  // namespace

void boundaryTerms(const GradientCurves& curves, const UnwrappedImage& strip, const EvidenceParams& params,
                   BoundaryTerms& terms) {
  contourTerms(curves, strip, params, terms);
  colourTerms(curves, strip, {}, terms);
}

void contourTerms(const GradientCurves& curves, const UnwrappedImage& strip, const EvidenceParams& params,
                  BoundaryTerms& terms) {
  contourContrast(curves, strip, {.reach = params.contrastReach * strip.pixel}, terms.scratch, terms.contrast);
  normalise(curves, strip, terms);
  terms.beyond.assign(curves.x.size(), 0.f);
  const float extent = kEdgeExtent * static_cast<float>(strip.pixel);
  std::vector<float>& edges = terms.scratch.sums;
  for (int c = 0; c < strip.curves; ++c) {
    const std::size_t row = curves.at(c, 0);
    const int reached = curves.reached[index(c)];
    const float* along = &curves.along[row];
    float* beyond = &terms.beyond[row];
    integrate(curves, c, &terms.contrast[row], edges);
    int past = 0, twice = 0;
    for (int k = 1; k < reached; ++k) {
      past = levelAt(along, reached, past, along[k] + extent);
      twice = levelAt(along, reached, twice, 2 * (along[k] + extent));
      beyond[k] = 1 + (edges[index(twice)] - edges[index(past)]) / extent;
    }
    for (int k = 1; k < reached; ++k) beyond[k] = quickLog(beyond[k]);
  }
  placeOutside(curves, strip, terms.scratch);
  sortColours(curves, strip, terms.scratch.colours);
}

void colourTerms(const GradientCurves& curves, const UnwrappedImage& strip, const KnownReach& known,
                 BoundaryTerms& terms) {
  std::vector<float>&logOdds = terms.scratch.logOdds, &foreign = terms.scratch.sums;
  spineLogOdds(curves, strip, known, terms.scratch.colours, logOdds);
  for (auto* plane : {&terms.inside, &terms.outside, &terms.farther}) {
    plane->resize(curves.x.size());
  }
  terms.rim.resize(known.outside.empty() ? 0 : curves.x.size());
  for (int c = 0; c < strip.curves; ++c) {
    const std::size_t row = curves.at(c, 0);
    const auto reached = index(curves.reached[index(c)]);
    const float* along = &curves.along[row];
    const std::uint16_t *halves = &terms.scratch.half[row], *fars = &terms.scratch.far[row];
    float *inside = &terms.inside[row], *outside = &terms.outside[row], *farther = &terms.farther[row];
    integrate(curves, c, &logOdds[row], foreign);
    inside[0] = outside[0] = farther[0] = 0;
    for (std::size_t k = 1; k < reached; ++k) {
      const std::size_t half = halves[k], far = fars[k];
      inside[k] = foreign[k] / along[k];
      const float run = along[half] - along[k];
      outside[k] = run > 1 ? (foreign[half] - foreign[k]) / run : 0.f;
      // Close to the frame the last that is known stands for the rest.
      farther[k] = far > half ? (foreign[far] - foreign[half]) / (along[far] - along[half]) : farther[k - 1];
    }
    for (float* plane : {inside, outside, farther}) std::fill(plane + reached, plane + curves.levels, 0.f);
    if (!known.outside.empty()) rimOf(curves, strip, c, foreign, terms.rim);
  }
}

void boundaryCosts(const GradientCurves& curves, const UnwrappedImage& strip, const BoundaryTerms& terms,
                   const EvidenceParams& params, std::vector<float>& costs) {
  const auto w = [](double weight) { return static_cast<float>(weight); };
  const float proximity = w(params.proximityWeight), contrast = w(params.contrastWeight);
  const float local = w(params.localContrastWeight), beyond = w(params.beyondWeight);
  const float inside = w(params.insideWeight), outside = w(params.outsideWeight);
  const float farther = kOuter * outside, rim = w(params.rimWeight);
  const float even = kHypothesisShare * static_cast<float>(strip.levels), doubt = w(params.doubt);
  costs.resize(curves.x.size());
  for (int c = 0; c < strip.curves; ++c) {
    const std::size_t row = curves.at(c, 0);
    const auto reached = index(curves.reached[index(c)]);
    float* cost = &costs[row];
    cost[0] = 0;
    const float *near = &strip.proximity[row], *across = &terms.contrast[row], *nearby = &terms.localContrast[row],
                *past = &terms.beyond[row], *in = &terms.inside[row], *out = &terms.outside[row],
                *far = &terms.farther[row];
    for (std::size_t k = 1; k < reached; ++k) {
      cost[k] = proximity * near[k] + contrast * across[k] + local * nearby[k] - beyond * past[k] - inside * in[k] +
                outside * out[k] + farther * far[k];
    }
    for (std::size_t k = 1; k < reached && !terms.rim.empty(); ++k) cost[k] += rim * terms.rim[row + k];
    float best = -1e9f, sum = 0;
    for (std::size_t k = 1; k < reached; ++k) best = cost[k] > best ? cost[k] : best;
    for (std::size_t k = 1; k < reached; ++k) cost[k] = quickExp(cost[k] - best);
    for (std::size_t k = 1; k < reached; ++k) sum += cost[k];
    const float share = even / sum;
    for (std::size_t k = 1; k < reached; ++k) cost[k] = -quickLog(cost[k] * share + doubt);
    std::fill(cost + reached, cost + curves.levels, 0.f);
  }
}

}  // namespace spineloft::ribs
