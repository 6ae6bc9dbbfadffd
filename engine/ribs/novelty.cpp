// Colour evidence: how foreign the colours along the curves are to the spine.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "engine/ribs/evidence.h"

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

using Histogram = std::vector<float>;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// The bins of one channel: from the 0.5th to the 99.5th percentile of the strip, and a little more.
struct Axis {
  float low = 0, scale = 1;
  int bin(float value) const {
    return std::clamp(static_cast<int>((value - low) * scale), 0, kBins - 1);
  }
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

// Blurs with (1, 2, 1) along each axis and makes the shares sum to 1.
void finish(Histogram& h) {
  Histogram out(kCells);
  for (std::size_t stride : {kCells / kBins, kCells / kBins / kBins, std::size_t{1}}) {
    for (std::size_t i = 0; i < kCells; ++i) {
      const std::size_t at = i / stride % kBins;
      out[i] = 2 * h[i] + (at > 0 ? h[i - stride] : 0) + (at + 1 < kBins ? h[i + stride] : 0);
    }
    h.swap(out);
  }
  float sum = 0;
  for (float v : h) sum += v;
  if (sum > 0) {
    for (float& v : h) v /= sum;
  }
}

// Cell of every entry of the strip.
void classify(const GradientCurves& curves, const Strip& strip, std::vector<std::uint16_t>& cells) {
  std::array<Axis, 3> axes;
  std::vector<float> values;
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
  cells.assign(curves.x.size(), 0);
  for (int c = 0; c < strip.curves; ++c) {
    for (int k = 0; k < curves.reached[index(c)]; ++k) {
      const auto& lab = strip.lab[curves.at(c, k)];
      const int cell =
          (axes[0].bin(lab[0]) * kBins + axes[1].bin(lab[1])) * kBins + axes[2].bin(lab[2]);
      cells[curves.at(c, k)] = static_cast<std::uint16_t>(cell);
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

struct Colours {
  Histogram all = Histogram(kCells), spine = Histogram(kCells);
  std::array<Histogram, kStretches> stretches;
};

Colours learn(const GradientCurves& curves, const Strip& strip,
              const std::vector<std::uint16_t>& cells, const std::vector<float>& known) {
  Colours colours;
  for (Histogram& h : colours.stretches) h.assign(kCells, 0.f);
  for (int c = 0; c < strip.curves; ++c) {
    // A curve counts for the stretches on both sides of it in proportion to nearness.
    const float at = positionOf(curves.layout, c) * kStretches - 0.5f;
    const int low = std::clamp(static_cast<int>(std::floor(at)), 0, kStretches - 1);
    const int high = std::min(low + 1, kStretches - 1);
    const float share = std::clamp(at - static_cast<float>(low), 0.f, 1.f);
    const bool side = c < curves.layout.ribs || (c >= curves.layout.ribs + curves.layout.fan &&
                                                 c < 2 * curves.layout.ribs + curves.layout.fan);
    const float near = std::max(kSpineReach * static_cast<float>(strip.pixel),
                                known.empty() ? 0.f : known[index(c)]);
    for (int k = 1; k < curves.reached[index(c)]; ++k) {
      const std::size_t i = curves.at(c, k);
      if (strip.isIgnored(i)) continue;
      const float run = curves.along[i] - curves.along[i - 1];
      colours.all[cells[i]] += run;
      if (!side || curves.along[i] > near) continue;
      colours.spine[cells[i]] += run;
      colours.stretches[index(low)][cells[i]] += run * (1 - share);
      colours.stretches[index(high)][cells[i]] += run * share;
    }
  }
  finish(colours.all);
  finish(colours.spine);
  for (Histogram& h : colours.stretches) finish(h);
  return colours;
}

}  // namespace

void spineNovelty(const GradientCurves& curves, const Strip& strip, const std::vector<float>& known,
                  std::vector<float>& novelty) {
  std::vector<std::uint16_t> cells;
  classify(curves, strip, cells);
  const Colours colours = learn(curves, strip, cells, known);
  novelty.assign(curves.x.size(), 0.f);
  // With the whole spine ignored nothing is known of its colours.
  if (std::ranges::all_of(colours.spine, [](float share) { return share == 0; })) return;
  float overlap = 0;  // Bhattacharyya coefficient
  for (std::size_t i = 0; i < kCells; ++i) overlap += std::sqrt(colours.all[i] * colours.spine[i]);
  const float trust = std::sqrt(std::max(0.f, 1 - overlap));
  std::array<Histogram, kStretches> table;
  for (std::size_t s = 0; s < table.size(); ++s) {
    table[s].resize(kCells);
    for (std::size_t i = 0; i < kCells; ++i) {
      const float own = 0.5f * (colours.spine[i] + colours.stretches[s][i]);
      const float ratio = std::log((colours.all[i] + kLeastShare) / (own + kLeastShare));
      table[s][i] = trust * std::clamp(ratio, -kMostNovelty, kMostNovelty);
    }
  }
  for (int c = 0; c < strip.curves; ++c) {
    const Histogram& own = table[index(stretchOf(curves.layout, c))];
    for (int k = 0; k < curves.reached[index(c)]; ++k) {
      const std::size_t i = curves.at(c, k);
      if (!strip.isIgnored(i)) novelty[i] = own[cells[i]];
    }
  }
}

}  // namespace spineloft::ribs
