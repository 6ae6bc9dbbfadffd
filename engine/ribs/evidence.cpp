#include "engine/ribs/evidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace spineloft::ribs {
namespace {

using Lab = std::array<float, 4>;
using Lab4 = float __attribute__((vector_size(16)));
struct PicturePointF {
  float x, y;
};

std::size_t index(int i) { return static_cast<std::size_t>(i); }

Lab4 load(const float* from) {
  Lab4 out;
  __builtin_memcpy(&out, from, sizeof out);
  return out;
}

// Lab difference over ± reach of arc length at every level of one curve; 0 where not reached, and
// where the stretch touches what is ignored.
void differences(const GradientCurves& curves, const Strip& strip, float reach, int curve,
                 Lab* out) {
  const int reached = curves.reached[index(curve)];
  const float* along = &curves.along[curves.at(curve, 0)];
  const Lab* lab = &strip.lab[curves.at(curve, 0)];
  std::fill(out, out + strip.levels, Lab{});
  int low = 0, high = 0, lastIgnored = -1;
  for (int k = 1; k < reached; ++k) {
    while (low < k - 1 && along[low] < along[k] - reach) ++low;
    const int before = std::max(high, k - 1);
    high = std::max(high, k);
    while (high < reached - 1 && along[high] < along[k] + reach) ++high;
    for (int q = before; q <= high; ++q) {
      if (strip.isIgnored(curves.at(curve, q))) lastIgnored = q;
    }
    if (lastIgnored >= low) continue;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      out[k][channel] = lab[high][channel] - lab[low][channel];
    }
  }
}

// The slants of the contour that are tried: half as many to either side, and none.
constexpr int kSlants = 5;

// A curve next to the one that is looked at, and the rise of the first slant towards it.
struct Neighbour {
  const Lab* difference;
  const float *x, *y;
  int reached;
  float slant;
};

// The strongest of the slants' sums of differences at level k of one curve, squared. `x`, `y` and
// `step` are the point and the distance from the one before.
float strongestSum(std::span<const Neighbour> neighbours, int k, PicturePointF at, float step) {
  std::array<Lab4, kSlants> sums{};
  for (const Neighbour& n : neighbours) {
    if (k >= n.reached) continue;
    const float dx = n.x[k] - at.x, dy = n.y[k] - at.y;
    const float rise = n.slant * std::sqrt(dx * dx + dy * dy) / step;
    for (int s = 1; s <= kSlants / 2; ++s) {
      const float moved = rise * static_cast<float>(s);
      const int shift = static_cast<int>(moved + (moved < 0 ? -0.5f : 0.5f));
      for (const int sign : {-1, 1}) {
        const int from = k + sign * shift;
        if (from < 1 || from >= n.reached) continue;
        sums[index(kSlants / 2 + sign * s)] += load(n.difference[from].data());
      }
    }
    sums[kSlants / 2] += load(n.difference[k].data());
  }
  float best = 0;
  for (const Lab4& s : sums) best = std::max(best, s[0] * s[0] + s[1] * s[1] + s[2] * s[2]);
  return best;
}

// Sum of a plane over arc length along one curve; sum[k] covers levels 1 … k.
void integrate(const GradientCurves& curves, int curve, const float* plane,
               std::vector<float>& sum) {
  const int reached = curves.reached[index(curve)];
  const float* along = &curves.along[curves.at(curve, 0)];
  sum.assign(index(reached), 0.f);
  for (int k = 1; k < reached; ++k) {
    sum[index(k)] = sum[index(k - 1)] + plane[k] * (along[k] - along[k - 1]);
  }
}

// Largest contrast of every curve; kUnknown where it was ignored, so that others are not measured
// against it.
constexpr float kUnknown = -1;
std::vector<float> strongestContrasts(const GradientCurves& curves, const Strip& strip,
                                      const std::vector<float>& contrast) {
  std::vector<float> strongest(index(curves.layout.total()), 0.f);
  for (int c = 0; c < curves.layout.total(); ++c) {
    for (int k = 1; k < curves.reached[index(c)]; ++k) {
      strongest[index(c)] = std::max(strongest[index(c)], contrast[curves.at(c, k)]);
    }
    for (int k = 1; k < curves.reached[index(c)] && strongest[index(c)] == 0; ++k) {
      if (strip.isIgnored(curves.at(c, k))) strongest[index(c)] = kUnknown;
    }
  }
  return strongest;
}

float median(std::vector<float>& values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Share of the curves' median strongest contrast that counts as a full edge, and the Lab
// differences below which nothing is believed to be one, in the whole strip and near by.
constexpr float kFullEdge = 0.7f, kLeastContrast = 2.f, kLeastLocalContrast = 1.5f;
// Curves to either side that "near by" means.
constexpr int kNearby = 10;
// Half the width that an edge fills along a curve, and what is left out beyond it, in map pixels.
constexpr float kEdgeExtent = 4.f;
// What colours farther outside count for one that is just outside.
constexpr float kFarther = 0.85f;
// The share of a curve's labels over which an even spread costs nothing.
constexpr float kEvenShare = 3.f / 16;

void normalise(const GradientCurves& curves, const Strip& strip, BoundaryTerms& terms) {
  const std::vector<float> strongest = strongestContrasts(curves, strip, terms.contrast);
  std::vector<float> window = strongest;
  std::erase(window, kUnknown);
  const float scale = std::max(kLeastContrast, kFullEdge * median(window));
  const int total = curves.layout.total();
  terms.localContrast.assign(terms.contrast.size(), 0.f);
  for (int c = 0; c < total; ++c) {
    window.clear();
    for (int j = -kNearby; j <= kNearby; ++j)
      window.push_back(strongest[index(((c + j) % total + total) % total)]);
    std::erase(window, kUnknown);
    const float local = std::max(kLeastLocalContrast, kFullEdge * median(window));
    for (int k = 1; k < curves.reached[index(c)]; ++k) {
      const std::size_t at = curves.at(c, k);
      terms.localContrast[at] = std::min(1.f, terms.contrast[at] / local);
      terms.contrast[at] = std::min(1.f, terms.contrast[at] / scale);
    }
  }
}

// The last level of a curve whose arc length is at most `length`, searched upwards from `from`.
int levelAt(const float* along, int reached, int from, float length) {
  while (from + 1 < reached && along[from + 1] <= length) ++from;
  return from;
}

}  // namespace

void contourContrast(const GradientCurves& curves, const Strip& strip, const ContrastParams& params,
                     std::vector<float>& contrast) {
  std::vector<Lab> difference(curves.x.size());
  for (int c = 0; c < strip.curves; ++c) {
    differences(curves, strip, static_cast<float>(params.reach), c, &difference[curves.at(c, 0)]);
  }
  contrast.assign(curves.x.size(), 0.f);
  std::vector<Neighbour> neighbours(index(2 * params.neighbours + 1));
  const float share = 1 / static_cast<float>(2 * params.neighbours + 1);
  for (int c = 0; c < strip.curves; ++c) {
    for (int j = -params.neighbours; j <= params.neighbours; ++j) {
      const int other = ((c + j) % strip.curves + strip.curves) % strip.curves;
      const std::size_t row = curves.at(other, 0);
      neighbours[index(j + params.neighbours)] = {
          &difference[row], &curves.x[row], &curves.y[row], curves.reached[index(other)],
          static_cast<float>(j < 0 ? -params.slant : params.slant)};
    }
    for (int k = 1; k < curves.reached[index(c)]; ++k) {
      const std::size_t at = curves.at(c, k);
      if (strip.isIgnored(at)) continue;
      const float step = std::max(1.f, curves.along[at] - curves.along[at - 1]);
      const float best = strongestSum(neighbours, k, {curves.x[at], curves.y[at]}, step);
      contrast[at] = std::sqrt(best) * share;
    }
  }
}

void boundaryTerms(const GradientCurves& curves, const Strip& strip, const EvidenceParams& params,
                   BoundaryTerms& terms) {
  contourContrast(curves, strip, {.reach = params.contrastReach * strip.pixel}, terms.contrast);
  normalise(curves, strip, terms);
  terms.beyond.assign(curves.x.size(), 0.f);
  const float extent = kEdgeExtent * static_cast<float>(strip.pixel);
  std::vector<float> edges;
  for (int c = 0; c < strip.curves; ++c) {
    const std::size_t row = curves.at(c, 0);
    const int reached = curves.reached[index(c)];
    const float* along = &curves.along[row];
    integrate(curves, c, &terms.contrast[row], edges);
    int past = 0, twice = 0;
    for (int k = 1; k < reached; ++k) {
      past = levelAt(along, reached, past, along[k] + extent);
      twice = levelAt(along, reached, twice, 2 * (along[k] + extent));
      terms.beyond[row + index(k)] =
          std::log1p((edges[index(twice)] - edges[index(past)]) / extent);
    }
  }
  colourTerms(curves, strip, {}, terms);
}

void colourTerms(const GradientCurves& curves, const Strip& strip, const std::vector<float>& known,
                 BoundaryTerms& terms) {
  std::vector<float> novelty, foreign;
  spineNovelty(curves, strip, known, novelty);
  for (auto* plane : {&terms.inside, &terms.outside, &terms.farther}) {
    plane->assign(curves.x.size(), 0.f);
  }
  const float margin = 2 * kEdgeExtent * static_cast<float>(strip.pixel);
  for (int c = 0; c < strip.curves; ++c) {
    const std::size_t row = curves.at(c, 0);
    const int reached = curves.reached[index(c)];
    const float* along = &curves.along[row];
    integrate(curves, c, &novelty[row], foreign);
    int half = 0, far = 0;
    const auto mean = [&](int from, int to) {
      return (foreign[index(to)] - foreign[index(from)]) / (along[to] - along[from]);
    };
    for (int k = 1; k < reached; ++k) {
      half = levelAt(along, reached, half, 1.5f * along[k] + margin);
      far = levelAt(along, reached, far, 2.5f * along[k] + 2 * margin);
      const std::size_t at = row + index(k);
      terms.inside[at] = mean(0, k);
      terms.outside[at] = along[half] - along[k] > 1 ? mean(k, half) : 0.f;
      // Close to the frame the last that is known stands for the rest.
      terms.farther[at] = far > half ? mean(half, far) : terms.farther[at - 1];
    }
  }
}

void boundaryCosts(const GradientCurves& curves, const Strip& strip, const BoundaryTerms& terms,
                   const EvidenceParams& params, std::vector<float>& costs) {
  const auto w = [](double weight) { return static_cast<float>(weight); };
  const float proximity = w(params.proximityWeight), contrast = w(params.contrastWeight);
  const float local = w(params.localContrastWeight), beyond = w(params.beyondWeight);
  const float inside = w(params.insideWeight), outside = w(params.outsideWeight);
  const float farther = kFarther * outside;
  const float even = kEvenShare * static_cast<float>(strip.levels), doubt = w(params.doubt);
  costs.assign(curves.x.size(), 0.f);
  for (int c = 0; c < strip.curves; ++c) {
    float best = -1e9f, sum = 0;
    const int reached = curves.reached[index(c)];
    for (int k = 1; k < reached; ++k) {
      const std::size_t i = curves.at(c, k);
      costs[i] = proximity * strip.proximity[i] + contrast * terms.contrast[i] +
                 local * terms.localContrast[i] - beyond * terms.beyond[i] -
                 inside * terms.inside[i] + outside * terms.outside[i] +
                 farther * terms.farther[i];
      best = std::max(best, costs[i]);
    }
    for (int k = 1; k < reached; ++k) {
      float& cost = costs[curves.at(c, k)];
      cost = std::exp(cost - best);
      sum += cost;
    }
    for (int k = 1; k < reached; ++k) {
      float& cost = costs[curves.at(c, k)];
      cost = -std::log(cost / sum * even + doubt);
    }
  }
}

}  // namespace spineloft::ribs
