#include "engine/ribs/evidence/ink_centreline.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/lanes.h"
#include "engine/ribs/evidence/feature_sampler.h"

namespace spineloft::ribs {
namespace {

// Breadth of the broadest line: a share of the map's longer side, at least so many map pixels, and at
// most a share of the curve's length.
constexpr double kBroadest = 0.012, kLeastBroadest = 4, kBroadestOfLength = 0.3;
// Lab difference between ink and paper at least, and the share of it by which the paper may differ.
constexpr float kLeastInk = 12, kSamePaper = 0.35f;
// An end this close to the ink stands beside it, map pixels.
constexpr int kBeside = 2;
constexpr int kMostReach = 48;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

float squaredDifference(Float4 a, Float4 b) {
  const Float4 d = a - b, squares = d * d;
  return squares[0] + squares[1] + squares[2];
}

// The colours along a curve, every map pixel from `reach` before a place to `reach` beyond it, as far
// as the curve goes: colour[i] is i − reach map pixels from the place, for low ≤ i ≤ high.
struct Profile {
  std::array<Float4, 2 * kMostReach + 1> colour;
  int reach, low, high;

  Profile(const GradientCurves& curves, const image::EdgeMap& edges, int curve, double along, int wanted)
      : reach(wanted), low(0), high(-1) {
    const FeatureSampler picture(edges);
    const std::size_t row = curves.at(curve, 0);
    const float *x = &curves.x[row], *y = &curves.y[row], *arcs = &curves.along[row];
    const int last = curves.reached[index(curve)] - 1;
    const auto pixel = static_cast<float>(std::max(edges.scaleX, edges.scaleY));
    const Float4 scale{static_cast<float>(1 / edges.scaleX), static_cast<float>(1 / edges.scaleY), 0, 0};
    const auto pointOf = [&](int k) { return (Float4{x[k], y[k], 0, 0} + 0.5f) * scale - 0.5f; };
    int label = 0;
    for (int i = 0; i <= 2 * reach; ++i) {
      const float at = static_cast<float>(along) + static_cast<float>(i - reach) * pixel;
      if (at < 0) low = i + 1;
      if (at < 0 || at > arcs[last]) continue;
      while (label + 1 < last && arcs[label + 1] <= at) ++label;
      const Float4 from = pointOf(label), to = pointOf(label + 1);
      const float share = (at - arcs[label]) / std::max(1e-9f, arcs[label + 1] - arcs[label]);
      colour[index(i)] = picture.featureAt(picture.locate(from + (to - from) * std::min(share, 1.f)));
      high = i;
    }
  }
};

// The first and last sample of the ink around `middle`, between paper `breadth` away on both sides.
struct Line {
  int first = 0, last = -1;
  float ink = 0;  // its squared difference from the paper; 0: no line
};
Line lineAround(const Profile& profile, int middle, int breadth) {
  const Float4 inside = profile.colour[index(std::max(profile.low, middle - breadth))];
  const Float4 outside = profile.colour[index(std::min(profile.high, middle + breadth))];
  const auto inkOf = [&](int i) {
    const Float4 here = profile.colour[index(i)];
    return lesser(squaredDifference(here, inside), squaredDifference(here, outside));
  };
  const float ink = inkOf(middle);
  if (ink < kLeastInk * kLeastInk || squaredDifference(inside, outside) > kSamePaper * kSamePaper * ink) return {};
  Line line{middle, middle, ink};
  while (line.first > profile.low && inkOf(line.first - 1) > ink / 4) --line.first;
  while (line.last < profile.high && inkOf(line.last + 1) > ink / 4) ++line.last;
  const bool open = line.first == profile.low || line.last == profile.high;
  if (open || line.last - line.first >= breadth) return {};
  return line;
}

}  // namespace

double middleOfLine(const GradientCurves& curves, const image::EdgeMap& edges, int curve, double along) {
  if (curves.reached[index(curve)] < 3) return along;
  const double pixel = std::max(edges.scaleX, edges.scaleY);
  const double broadest = std::min(std::max(kLeastBroadest, kBroadest * std::max(edges.width, edges.height)),
                                   kBroadestOfLength * along / pixel);
  const int breadth = static_cast<int>(broadest);
  if (breadth < 2) return along;
  // The line may lie on either side of the place, and paper has to show on both sides of it.
  const int reach = std::min(kMostReach, static_cast<int>(std::ceil(1.5 * broadest)));
  const Profile profile(curves, edges, curve, along, reach);
  Line best;
  const int from = std::max(profile.low + 1, reach - breadth);
  const int to = std::min(profile.high - 1, reach + breadth);
  for (int middle = from; middle <= to; ++middle) {
    const Line line = lineAround(profile, middle, breadth);
    const bool beside = line.first <= reach + kBeside && line.last >= reach - kBeside;
    if (beside && line.ink > best.ink) best = line;
  }
  return best.ink > 0 ? along + (0.5 * (best.first + best.last) - reach) * pixel : along;
}

}  // namespace spineloft::ribs
