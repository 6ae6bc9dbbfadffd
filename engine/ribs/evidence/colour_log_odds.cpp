// Colour evidence: log-odds of the colours along the curves, against those at the spine.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "engine/base/lanes.h"
#include "engine/ribs/evidence/evidence.h"

namespace spineloft::ribs {
namespace {

constexpr int kBins = kColourBins;
constexpr std::size_t kCells = static_cast<std::size_t>(kBins) * kBins * kBins;
constexpr int kStretches = 8;
// The spine's own colours are taken this close to it, in map pixels: surely inside the object.
constexpr float kSpineReach = 3;
// What the stretch counts for of the object's colours: before what is around it is known, and after.
// Where a part runs out to another thing, the stretch is that thing's.
constexpr float kStretchFirst = 0.3f, kStretchLater = 0.5f;
// Below it a colour's share is not known: where all colours are set against the spine's, and where
// those around the object are known.
constexpr float kLeastShare = 2e-4f, kLeastAround = 3e-3f;
// What the stretch counts for of what is around the object: that changes along it more than the object.
constexpr float kNearAround = 0.8f;
// What is around the object is learned up to this many times as far as it begins, and so many map
// pixels more.
constexpr float kAround = 3.5f, kAroundMargin = 16;
constexpr float kMostLogOdds = 2;
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
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1));
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
void classify(const GradientCurves& curves, const UnwrappedImage& strip, ColourTables& colours) {
  std::array<Axis, 3> axes;
  std::vector<float>& values = colours.values;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    values.clear();
    for (int c = 0; c < strip.curves; ++c) {
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
      const Int4 bin = __builtin_convertvector(least4(most4(bins, all4(0)), all4(kBins - 1)), Int4);
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

// Adds up a histogram of the whole and of the stretches.
class Learner {
 public:
  Learner(const GradientCurves& curves, const UnwrappedImage& strip, ColourTables& colours, std::vector<float>& whole,
          std::vector<float>& stretches)
      : curves_(curves), strip_(strip), colours_(colours), whole_(whole), stretches_(stretches) {
    whole_.assign(kCells, 0.f);
    stretches_.assign(kStretches * kCells, 0.f);
  }

  // The colours of one curve from one arc length to another.
  void add(int c, float from, float to) {
    // A curve counts for the stretches on both sides of it in proportion to nearness.
    const float at = positionOf(curves_.layout, c) * kStretches - 0.5f;
    const int low = std::clamp(static_cast<int>(std::floor(at)), 0, kStretches - 1);
    const int high = std::min(low + 1, kStretches - 1);
    const float share = std::clamp(at - static_cast<float>(low), 0.f, 1.f);
    float* lower = &stretches_[index(low) * kCells];
    float* upper = &stretches_[index(high) * kCells];
    for (int k = 1; k < curves_.reached[index(c)]; ++k) {
      const std::size_t i = curves_.at(c, k);
      if (curves_.along[i] > to) break;
      if (curves_.along[i] < from || strip_.isIgnored(i)) continue;
      const float run = curves_.along[i] - curves_.along[i - 1];
      const std::size_t cell = colours_.cells[i];
      whole_[cell] += run;
      lower[cell] += run * (1 - share);
      upper[cell] += run * share;
    }
  }

  void done() {
    finish(whole_.data(), colours_.blurred);
    for (std::size_t s = 0; s < kStretches; ++s) finish(&stretches_[s * kCells], colours_.blurred);
  }

 private:
  const GradientCurves& curves_;
  const UnwrappedImage& strip_;
  ColourTables& colours_;
  std::vector<float>&whole_, &stretches_;
};

// The colours of the object, as far as it is known.
void learnObject(const GradientCurves& curves, const UnwrappedImage& strip, const std::vector<float>& inside,
                 ColourTables& colours) {
  Learner learner(curves, strip, colours, colours.spine, colours.stretches);
  const float reach = kSpineReach * static_cast<float>(strip.pixel);
  for (int c = 0; c < strip.curves; ++c) {
    if (!ofRib(curves.layout, c)) continue;
    learner.add(c, 0, inside.empty() ? reach : std::max(reach, inside[index(c)]));
  }
  learner.done();
}

// The colours of what is around it.
void learnAround(const GradientCurves& curves, const UnwrappedImage& strip, const std::vector<float>& outside,
                 ColourTables& colours) {
  Learner learner(curves, strip, colours, colours.around, colours.aroundStretches);
  const float margin = kAroundMargin * static_cast<float>(strip.pixel);
  for (int c = 0; c < strip.curves; ++c) learner.add(c, outside[index(c)], kAround * outside[index(c)] + margin);
  learner.done();
}

float held(float ratio) {
  const float low = ratio < -kMostLogOdds ? -kMostLogOdds : ratio;
  return low > kMostLogOdds ? kMostLogOdds : low;
}

// The log-odds of every cell for every stretch, against all colours.
void compareWithAll(ColourTables& colours) {
  const std::vector<float>&all = colours.all, &spine = colours.spine;
  float overlap = 0;  // Bhattacharyya coefficient
  for (std::size_t i = 0; i < kCells; ++i) overlap += std::sqrt(all[i] * spine[i]);
  const float trust = std::sqrt(std::max(0.f, 1 - overlap));
  colours.logOdds.resize(kStretches * kCells);
  for (std::size_t s = 0; s < kStretches; ++s) {
    const float* stretch = &colours.stretches[s * kCells];
    float* out = &colours.logOdds[s * kCells];
    for (std::size_t i = 0; i < kCells; ++i) {
      const float own = spine[i] + kStretchFirst * (stretch[i] - spine[i]);
      out[i] = trust * held(quickLog((all[i] + kLeastShare) / (own + kLeastShare)));
    }
  }
}

// The same against those around the object.
void compareWithAround(ColourTables& colours) {
  colours.logOdds.resize(kStretches * kCells);
  for (std::size_t s = 0; s < kStretches; ++s) {
    const float *stretch = &colours.stretches[s * kCells], *near = &colours.aroundStretches[s * kCells];
    float* out = &colours.logOdds[s * kCells];
    for (std::size_t i = 0; i < kCells; ++i) {
      const float own = colours.spine[i] + kStretchLater * (stretch[i] - colours.spine[i]);
      const float other = colours.around[i] + kNearAround * (near[i] - colours.around[i]);
      out[i] = held(quickLog((other + kLeastAround) / (own + kLeastAround)));
    }
  }
}

}  // namespace

void sortColours(const GradientCurves& curves, const UnwrappedImage& strip, ColourTables& colours) {
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

void spineLogOdds(const GradientCurves& curves, const UnwrappedImage& strip, const KnownReach& known,
                  ColourTables& colours, std::vector<float>& logOdds) {
  learnObject(curves, strip, known.inside, colours);
  logOdds.resize(curves.x.size());
  // With the whole spine ignored nothing is known of its colours.
  if (std::ranges::all_of(colours.spine, [](float share) { return share == 0; })) {
    std::ranges::fill(logOdds, 0.f);
    return;
  }
  if (known.outside.empty()) {
    compareWithAll(colours);
  } else {
    learnAround(curves, strip, known.outside, colours);
    compareWithAround(colours);
  }
  for (int c = 0; c < strip.curves; ++c) {
    const float* own = &colours.logOdds[index(stretchOf(curves.layout, c)) * kCells];
    const std::size_t row = curves.at(c, 0), end = row + index(curves.reached[index(c)]);
    for (std::size_t i = row; i < end; ++i) logOdds[i] = own[colours.cells[i]];
    for (std::size_t i = row; i < end && !strip.ignored.empty(); ++i) {
      if (strip.isIgnored(i)) logOdds[i] = 0;
    }
    std::fill(&logOdds[row] + (end - row), &logOdds[row] + curves.levels, 0.f);
  }
}

}  // namespace spineloft::ribs
