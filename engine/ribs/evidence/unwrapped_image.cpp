// The picture along the gradient curves.
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/shared_loop.h"
#include "engine/base/short_lanes.h"
#include "engine/ribs/evidence/evidence.h"
#include "engine/ribs/evidence/feature_sampler.h"

namespace spineloft::ribs {
namespace {

// What one curve stands for: the stretch of its level set half-way to either neighbour, sampled this
// far apart (map pixels), at most so many times on either side.
constexpr float kBandStep = 2;
constexpr int kMostBand = 8;

constexpr std::size_t index(int i) { return static_cast<std::size_t>(i); }

// shares[s][q]: how far the q-th of s samples is on the way to the neighbour.
using Shares = std::array<std::array<float, kMostBand + 1>, kMostBand + 1>;
constexpr Shares makeShares() {
  Shares shares{};
  for (int s = 0; s <= kMostBand; ++s) {
    for (int q = 0; q <= kMostBand; ++q)
      shares[index(s)][index(q)] = static_cast<float>(q) / static_cast<float>(2 * s + 1);
  }
  return shares;
}
constexpr Shares kShares = makeShares();

static_assert(2 * kMostBand + 1 <= FeatureSampler::kMostSamples);

// Sums of colour and nearness.
class Sampler {
 public:
  explicit Sampler(const image::EdgeMap& map) : picture(map) {}

  void clear() {
    sum_ = Int4{};
    count_ = 0;
  }
  void add(Int4 look) {
    sum_ += look;
    ++count_;
  }
  void read(std::array<float, 4>& lab, float& near) const {
    const Float4 mean = FeatureSampler::meanOf(sum_, count_);
    lab = {mean[0], mean[1], mean[2], 0};
    near = mean[3];
  }

  const FeatureSampler picture;

 private:
  Int4 sum_{};
  int count_ = 0;
};

// Map coordinates of all points of these curves, and how many band samples lie between each curve and
// the next one, on either's half of the way.
void placeBands(const GradientCurves& curves, LoopShare of, const image::EdgeMap& edges, float apart,
                UnwrapScratch& scratch) {
  const auto scaleX = static_cast<float>(1 / edges.scaleX), scaleY = static_cast<float>(1 / edges.scaleY);
  const int total = curves.layout.total();
  for (int c = of.first; c < of.end; ++c) {
    const std::size_t row = curves.at(c, 0), next = curves.at(c + 1 < total ? c + 1 : 0, 0);
    const int reached = curves.reached[index(c)];
    const int both = std::min(reached, curves.reached[index(c + 1 < total ? c + 1 : 0)]);
    const float *x = &curves.x[row], *y = &curves.y[row];
    float *mapX = &scratch.mapX[row], *mapY = &scratch.mapY[row];
    for (int k = 0; k < reached; ++k) {
      mapX[k] = (x[k] + 0.5f) * scaleX - 0.5f;
      mapY[k] = (y[k] + 0.5f) * scaleY - 0.5f;
    }
    const float *nextX = &curves.x[next], *nextY = &curves.y[next];
    float* steps = &scratch.steps[row];
    for (int k = 0; k < both; ++k) {
      const float dx = nextX[k] - x[k], dy = nextY[k] - y[k];
      const float room = 0.5f * std::sqrt(dx * dx + dy * dy) / apart;
      steps[k] = room < kMostBand ? room : static_cast<float>(kMostBand);
    }
    std::fill(steps + both, steps + curves.levels, 0.f);
  }
}

// Labels of all curves that are sampled before farther ones. A curve that crosses the map's rows would
// touch another page of memory with every label, and rows that lie a power of two apart drive each
// other out of the cache; a few labels along the whole level set stay together.
constexpr int kBandOfLabels = 16;
struct Piece {
  int curve, first, end;  // labels first … end − 1
};

// Fills a piece of one curve's row; `marked`: whether something is ignored.
template <bool marked>
void sampleCurve(const GradientCurves& curves, const IgnoredEdges* ignored, Piece piece, Sampler& sampler,
                 UnwrappedImage& strip) {
  const int c = piece.curve;
  const int total = strip.curves;
  const std::size_t row = curves.at(c, 0);
  const std::size_t before = curves.at(c > 0 ? c - 1 : total - 1, 0);
  const std::size_t after = curves.at(c + 1 < total ? c + 1 : 0, 0);
  const UnwrapScratch& s = strip.scratch;
  const auto sample = [&](Float4 at) {
    const FeatureSampler::Place place = sampler.picture.locate(at);
    if constexpr (marked) {
      if (ignored->mask[sampler.picture.nearest(place)] != 0) return false;
      sampler.add(sampler.picture.featureAt(place, ignored->proximity));
    } else {
      sampler.add(sampler.picture.featureAt(place));
    }
    return true;
  };
  for (std::size_t k = index(piece.first); k < index(piece.end); ++k) {
    const Float4 here{s.mapX[row + k], s.mapY[row + k], 0, 0};
    sampler.clear();
    if (!sample(here)) {
      strip.ignored[row + k] = 1;
      sampler.add(sampler.picture.featureAt(sampler.picture.locate(here)));
      sampler.read(strip.lab[row + k], strip.proximity[row + k]);
      strip.proximity[row + k] = 0;
      continue;
    }
    const auto band = [&](std::size_t other, float room) {
      const auto steps = static_cast<std::size_t>(room);
      if (steps == 0) return;
      const Float4 way = Float4{s.mapX[other + k], s.mapY[other + k], 0, 0} - here;
      for (std::size_t q = 1; q <= steps; ++q) sample(here + kShares[steps][q] * way);
    };
    band(before, s.steps[before + k]);
    band(after, s.steps[row + k]);
    sampler.read(strip.lab[row + k], strip.proximity[row + k]);
  }
}

bool isMarked(const IgnoredEdges* ignored) { return ignored != nullptr && !ignored->empty(); }

// Fills the rows of these curves.
void sampleCurves(const GradientCurves& curves, LoopShare of, const image::EdgeMap& edges, const IgnoredEdges* ignored,
                  UnwrappedImage& strip) {
  Sampler sampler(edges);
  for (int first = 0; first < strip.levels; first += kBandOfLabels) {
    for (int c = of.first; c < of.end; ++c) {
      const int reached = curves.reached[index(c)];
      if (reached <= first) continue;
      const Piece piece{c, first, std::min(first + kBandOfLabels, reached)};
      if (isMarked(ignored)) {
        sampleCurve<true>(curves, ignored, piece, sampler, strip);
      } else {
        sampleCurve<false>(curves, ignored, piece, sampler, strip);
      }
    }
  }
  for (int c = of.first; c < of.end; ++c) {
    const std::size_t end = curves.at(c, curves.reached[index(c)]), row = curves.at(c, 0);
    const std::size_t next = row + index(curves.levels);
    std::fill(&strip.proximity[row] + (end - row), &strip.proximity[row] + (next - row), 0.f);
    std::fill(&strip.lab[row] + (end - row), &strip.lab[row] + (next - row), std::array<float, 4>{});
  }
}

}  // namespace

void unwrapImage(const GradientCurves& curves, const image::EdgeMap& edges, const IgnoredEdges* ignored,
                 UnwrappedImage& strip) {
  const bool marked = isMarked(ignored);
  strip.curves = curves.layout.total();
  strip.levels = curves.levels;
  strip.pixel = std::max(edges.scaleX, edges.scaleY);
  strip.proximity.resize(curves.x.size());
  strip.lab.resize(curves.x.size());
  strip.ignored.assign(marked ? curves.x.size() : 0, 0);
  for (auto* plane : {&strip.scratch.mapX, &strip.scratch.mapY, &strip.scratch.steps}) plane->resize(curves.x.size());
  const float apart = kBandStep * static_cast<float>(strip.pixel);
  sharedLoop(strip.curves, [&](LoopShare of) { placeBands(curves, of, edges, apart, strip.scratch); });
  sharedLoop(strip.curves, [&](LoopShare of) { sampleCurves(curves, of, edges, ignored, strip); });
}

}  // namespace spineloft::ribs
