#include "engine/ribs/evidence.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spineloft::ribs {
namespace {

// Where a picture point lies between the four map pixels around it (clamped to the map).
struct Bilinear {
  std::size_t i00, i10, i01, i11;
  float u, v;
};

Bilinear locate(const image::EdgeMap& map, float x, float y) {
  const auto at = map.toMap({static_cast<double>(x), static_cast<double>(y)});
  const float mx = std::clamp(static_cast<float>(at.x), 0.f, static_cast<float>(map.width - 1));
  const float my = std::clamp(static_cast<float>(at.y), 0.f, static_cast<float>(map.height - 1));
  const int x0 = std::min(static_cast<int>(mx), std::max(0, map.width - 2));
  const int y0 = std::min(static_cast<int>(my), std::max(0, map.height - 2));
  const auto row = static_cast<std::size_t>(map.width);
  const std::size_t base = static_cast<std::size_t>(y0) * row + static_cast<std::size_t>(x0);
  const std::size_t right = map.width > 1 ? 1 : 0, below = map.height > 1 ? row : 0;
  return {base,
          base + right,
          base + below,
          base + right + below,
          mx - static_cast<float>(x0),
          my - static_cast<float>(y0)};
}

// Value of one channel of an interleaved plane between the four pixels.
float mix(const Bilinear& b, const std::vector<float>& plane, std::size_t stride,
          std::size_t channel) {
  const auto at = [&](std::size_t pixel) { return plane[pixel * stride + channel]; };
  const float top = at(b.i00) + (at(b.i10) - at(b.i00)) * b.u;
  const float bottom = at(b.i01) + (at(b.i11) - at(b.i01)) * b.u;
  return top + (bottom - top) * b.v;
}

// Lab difference over ± reach of arc length at every level, per channel.
void differences(const GradientCurves& curves, const Strip& strip, float reach,
                 std::array<std::vector<float>, 3>& out) {
  for (auto& plane : out) plane.assign(curves.x.size(), 0.f);
  for (int c = 0; c < strip.curves; ++c) {
    const int reached = curves.reached[static_cast<std::size_t>(c)];
    const std::size_t row = curves.at(c, 0);
    int low = 0, high = 0;
    for (int k = 1; k < reached; ++k) {
      const float here = curves.along[curves.at(c, k)];
      while (low < k - 1 && curves.along[curves.at(c, low)] < here - reach) ++low;
      high = std::max(high, k);
      while (high < reached - 1 && curves.along[curves.at(c, high)] < here + reach) ++high;
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const float* from = &strip.lab[channel][row];
        out[channel][row + static_cast<std::size_t>(k)] = from[high] - from[low];
      }
    }
  }
}

// Strongest of the slanted averages of `difference` around one place.
float bestSlant(const GradientCurves& curves, const std::array<std::vector<float>, 3>& difference,
                const ContrastParams& params, int curve, int level) {
  const int total = curves.layout.total();
  const std::size_t at = curves.at(curve, level);
  const float step = std::max(1.f, curves.along[at] - curves.along[at - 1]);
  float best = 0;
  for (int slant = -2; slant <= 2; ++slant) {
    std::array<float, 3> sum{};
    for (int j = -params.neighbours; j <= params.neighbours; ++j) {
      const int other = (curve + j + total) % total;
      const int reached = curves.reached[static_cast<std::size_t>(other)];
      if (level >= reached) continue;
      const std::size_t there = curves.at(other, level);
      const float run = std::hypot(curves.x[there] - curves.x[at], curves.y[there] - curves.y[at]);
      const float rise = static_cast<float>(slant * params.slant) * (j < 0 ? -run : run) / step;
      const int moved = level + static_cast<int>(std::lround(rise));
      if (moved < 1 || moved >= reached) continue;
      const std::size_t from = curves.at(other, moved);
      for (std::size_t channel = 0; channel < 3; ++channel)
        sum[channel] += difference[channel][from];
    }
    best = std::max(best, sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
  }
  return std::sqrt(best) / static_cast<float>(2 * params.neighbours + 1);
}

// Share of the median of the curves' strongest contrasts that counts as a full edge, and the Lab
// difference below which nothing is believed to be one.
constexpr float kFullEdge = 0.7f;
constexpr float kLeastContrast = 2.f;

float contrastScale(const Strip& strip, const std::vector<float>& contrast) {
  std::vector<float> strongest(static_cast<std::size_t>(strip.curves));
  const auto levels = static_cast<std::size_t>(strip.levels);
  for (std::size_t c = 0; c < strongest.size(); ++c) {
    strongest[c] = *std::max_element(&contrast[c * levels], &contrast[c * levels] + levels);
  }
  const auto middle = strongest.begin() + static_cast<std::ptrdiff_t>(strongest.size() / 2);
  std::nth_element(strongest.begin(), middle, strongest.end());
  return std::max(kLeastContrast, kFullEdge * *middle);
}

}  // namespace

void sampleStrip(const GradientCurves& curves, const image::EdgeMap& edges, Strip& strip) {
  strip.curves = curves.layout.total();
  strip.levels = curves.levels;
  strip.proximity.assign(curves.x.size(), 0.f);
  for (auto& plane : strip.lab) plane.assign(curves.x.size(), 0.f);
  for (int c = 0; c < strip.curves; ++c) {
    const int reached = curves.reached[static_cast<std::size_t>(c)];
    for (int k = 0; k < reached; ++k) {
      const std::size_t at = curves.at(c, k);
      const Bilinear place = locate(edges, curves.x[at], curves.y[at]);
      strip.proximity[at] = mix(place, edges.proximity, 1, 0);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        strip.lab[channel][at] = mix(place, edges.lab, 3, channel);
      }
    }
  }
}

void contourContrast(const GradientCurves& curves, const Strip& strip, const ContrastParams& params,
                     std::vector<float>& contrast) {
  std::array<std::vector<float>, 3> difference;
  differences(curves, strip, static_cast<float>(params.reach), difference);
  contrast.assign(curves.x.size(), 0.f);
  for (int c = 0; c < strip.curves; ++c) {
    for (int k = 1; k < curves.reached[static_cast<std::size_t>(c)]; ++k) {
      contrast[curves.at(c, k)] = bestSlant(curves, difference, params, c, k);
    }
  }
}

void edgeCosts(const GradientCurves& curves, const Strip& strip, const EvidenceParams& params,
               double mapScale, std::vector<float>& costs) {
  contourContrast(curves, strip, {.reach = params.contrastReach * mapScale}, costs);
  const float scale = contrastScale(strip, costs);
  const auto nearWeight = static_cast<float>(params.proximityWeight);
  const auto contrastWeight = static_cast<float>(params.contrastWeight);
  for (std::size_t i = 0; i < costs.size(); ++i) {
    costs[i] = nearWeight * (1 - strip.proximity[i]) +
               contrastWeight * (1 - std::min(1.f, costs[i] / scale));
  }
}

}  // namespace spineloft::ribs
