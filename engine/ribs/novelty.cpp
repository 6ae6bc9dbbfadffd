// Colour evidence: how foreign the colours along the curves are to the spine.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "engine/ribs/evidence.h"
#include "engine/ribs/lanes.h"

namespace spineloft::ribs {
namespace {

constexpr int kBins = 12;  // per Lab channel
constexpr std::size_t kCells = static_cast<std::size_t>(kBins) * kBins * kBins;
constexpr int kStretches = 8;
// The spine's own colours are taken this close to it, in map pixels: surely inside the object.
constexpr float kSpineReach = 4;
constexpr float kLeastShare = 2e-4f;  // below it a colour's share is not known
constexpr float kMostNovelty = 2;
// Smallest ranges that the bins of lightness and of a and b span, Lab units.
constexpr float kLightRange = 20, kColourRange = 14;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// The bins of one channel: from the 0.5th to the 99.5th percentile of the strip, and a little more.
struct Axis {
  float low = 0, scale = 1;
};

Axis axisOf(std::vector<float>& values, float leastRange) {
  if (values.empty()) return {};
  const auto share = [&](double q) {
    const auto at =
        values.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
  };
  const float low = share(0.005), range = std::max(share(0.995) - low, leastRange);
  return {low - 0.02f * range, kBins / (1.04f * range)};
}

// One axis of the blur with (1, 2, 1): entries `stride` apart are neighbours along it.
void blurAlong(const float* __restrict in, std::size_t stride, float* __restrict out) {
  for (std::size_t block = 0; block < kCells; block += stride * kBins) {
    for (std::size_t bin = 0; bin < kBins; ++bin) {
      const float* here = in + block + bin * stride;
      float* to = out + block + bin * stride;
      for (std::size_t i = 0; i < stride; ++i) to[i] = 2 * here[i];
      if (bin > 0) {
        for (std::size_t i = 0; i < stride; ++i) to[i] += *(here + i - stride);
      }
      if (bin + 1 < kBins) {
        for (std::size_t i = 0; i < stride; ++i) to[i] += here[i + stride];
      }
    }
  }
}
// The axis whose neighbours are next to each other.
void blurRows(const float* __restrict in, float* __restrict out) {
  for (std::size_t row = 0; row < kCells; row += kBins) {
    const float* here = in + row;
    float* to = out + row;
    to[0] = 2 * here[0] + here[1];
    for (std::size_t i = 1; i + 1 < kBins; ++i) to[i] = 2 * here[i] + here[i - 1] + here[i + 1];
    to[kBins - 1] = 2 * here[kBins - 1] + here[kBins - 2];
  }
}

// Blurs along each axis and makes the shares sum to 1.
void finish(float* h, std::vector<float>& blurred) {
  blurred.resize(2 * kCells);
  float *first = blurred.data(), *second = first + kCells;
  blurAlong(h, kCells / kBins, first);
  blurAlong(first, kCells / kBins / kBins, second);
  blurRows(second, h);
  float sum = 0;
  for (std::size_t i = 0; i < kCells; ++i) sum += h[i];
  if (sum > 0) {
    for (std::size_t i = 0; i < kCells; ++i) h[i] /= sum;
  }
}

// Cell of every entry of the strip.
void classify(const GradientCurves& curves, const Strip& strip, ColourTables& colours) {
  std::array<Axis, 3> axes;
  std::vector<float>& values = colours.values;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    values.clear();
    for (int c = 0; c < strip.curves; c += 2) {
      for (int k = 0; k < curves.reached[index(c)]; k += 4) {
        const std::size_t at = curves.at(c, k);
        if (!strip.isIgnored(at)) values.push_back(strip.lab[at][channel]);
      }
    }
    axes[channel] = axisOf(values, channel == 0 ? kLightRange : kColourRange);
  }
  const Float4 low{axes[0].low, axes[1].low, axes[2].low, 0};
  const Float4 scale{axes[0].scale, axes[1].scale, axes[2].scale, 0};
  colours.cells.resize(curves.x.size());
  for (int c = 0; c < strip.curves; ++c) {
    const std::size_t row = curves.at(c, 0), end = row + index(curves.reached[index(c)]);
    for (std::size_t at = row; at < end; ++at) {
      const Float4 bins = (load4(strip.lab[at].data()) - low) * scale;
      const Int4 bin =
          __builtin_convertvector(least4(most4(bins, all4(0)), all4(kBins - 1)), Int4);
      colours.cells[at] = static_cast<std::uint16_t>((bin[0] * kBins + bin[1]) * kBins + bin[2]);
    }
  }
}

// Position of a curve along the spine, 0…1; fans belong to their end.
float positionOf(const CurveLayout& layout, int curve) {
  const auto last = static_cast<float>(std::max(1, layout.ribs - 1));
  if (curve < layout.ribs) return static_cast<float>(curve) / last;
  if (curve < layout.ribs + layout.fan) return 1;
  const int rib = 2 * layout.ribs + layout.fan - 1 - curve;
  return rib >= 0 ? static_cast<float>(rib) / last : 0;
}

int stretchOf(const CurveLayout& layout, int curve) {
  return std::min(kStretches - 1, static_cast<int>(positionOf(layout, curve) * kStretches));
}

// Whether a curve is one of a rib, not of the fans.
bool ofRib(const CurveLayout& layout, int c) {
  return c < layout.ribs || (c >= layout.ribs + layout.fan && c < 2 * layout.ribs + layout.fan);
}

// The shares of the cells close to the spine, or up to what is known, in all and by stretch.
void learn(const GradientCurves& curves, const Strip& strip, const std::vector<float>& known,
           ColourTables& colours) {
  colours.spine.assign(kCells, 0.f);
  colours.stretches.assign(kStretches * kCells, 0.f);
  const float reach = kSpineReach * static_cast<float>(strip.pixel);
  for (int c = 0; c < strip.curves; ++c) {
    if (!ofRib(curves.layout, c)) continue;
    // A curve counts for the stretches on both sides of it in proportion to nearness.
    const float at = positionOf(curves.layout, c) * kStretches - 0.5f;
    const int low = std::clamp(static_cast<int>(std::floor(at)), 0, kStretches - 1);
    const int high = std::min(low + 1, kStretches - 1);
    const float share = std::clamp(at - static_cast<float>(low), 0.f, 1.f);
    const float near = std::max(reach, known.empty() ? 0.f : known[index(c)]);
    float* lower = &colours.stretches[index(low) * kCells];
    float* upper = &colours.stretches[index(high) * kCells];
    for (int k = 1; k < curves.reached[index(c)]; ++k) {
      const std::size_t i = curves.at(c, k);
      if (curves.along[i] > near) break;
      if (strip.isIgnored(i)) continue;
      const float run = curves.along[i] - curves.along[i - 1];
      colours.spine[colours.cells[i]] += run;
      lower[colours.cells[i]] += run * (1 - share);
      upper[colours.cells[i]] += run * share;
    }
  }
  finish(colours.spine.data(), colours.blurred);
  for (std::size_t s = 0; s < kStretches; ++s)
    finish(&colours.stretches[s * kCells], colours.blurred);
}

// How foreign every cell is to every stretch.
void compare(ColourTables& colours) {
  const std::vector<float>&all = colours.all, &spine = colours.spine;
  float overlap = 0;  // Bhattacharyya coefficient
  for (std::size_t i = 0; i < kCells; ++i) overlap += std::sqrt(all[i] * spine[i]);
  const float trust = std::sqrt(std::max(0.f, 1 - overlap));
  colours.foreign.resize(kStretches * kCells);
  for (std::size_t s = 0; s < kStretches; ++s) {
    const float* stretch = &colours.stretches[s * kCells];
    float* out = &colours.foreign[s * kCells];
    for (std::size_t i = 0; i < kCells; ++i) {
      const float own = 0.5f * (spine[i] + stretch[i]);
      const float ratio = quickLog((all[i] + kLeastShare) / (own + kLeastShare));
      const float low = ratio < -kMostNovelty ? -kMostNovelty : ratio;
      out[i] = trust * (low > kMostNovelty ? kMostNovelty : low);
    }
  }
}

}  // namespace

void sortColours(const GradientCurves& curves, const Strip& strip, ColourTables& colours) {
  classify(curves, strip, colours);
  colours.all.assign(kCells, 0.f);
  for (int c = 0; c < strip.curves; ++c) {
    for (int k = 1; k < curves.reached[index(c)]; ++k) {
      const std::size_t i = curves.at(c, k);
      if (!strip.isIgnored(i)) colours.all[colours.cells[i]] += curves.along[i] - curves.along[i - 1];
    }
  }
  finish(colours.all.data(), colours.blurred);
}

void spineNovelty(const GradientCurves& curves, const Strip& strip, const std::vector<float>& known,
                  ColourTables& colours, std::vector<float>& novelty) {
  learn(curves, strip, known, colours);
  novelty.resize(curves.x.size());
  // With the whole spine ignored nothing is known of its colours.
  if (std::ranges::all_of(colours.spine, [](float share) { return share == 0; })) {
    std::ranges::fill(novelty, 0.f);
    return;
  }
  compare(colours);
  for (int c = 0; c < strip.curves; ++c) {
    const float* own = &colours.foreign[index(stretchOf(curves.layout, c)) * kCells];
    const std::size_t row = curves.at(c, 0), end = row + index(curves.reached[index(c)]);
    for (std::size_t i = row; i < end; ++i) novelty[i] = own[colours.cells[i]];
    for (std::size_t i = row; i < end && !strip.ignored.empty(); ++i) {
      if (strip.isIgnored(i)) novelty[i] = 0;
    }
    std::fill(&novelty[row] + (end - row), &novelty[row] + curves.levels, 0.f);
  }
}

}  // namespace spineloft::ribs
