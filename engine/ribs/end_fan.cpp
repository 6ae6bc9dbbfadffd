#include "engine/ribs/end_fan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "engine/ribs/pen_line.h"

namespace spineloft::ribs {
namespace {

// How strongly a cap is held to its guessed shape, against evidence that spans about 1.
constexpr float kCapWeight = 0.5f;
// Extents that are tried, in half widths, evenly by ratio.
constexpr int kExtents = 24;
constexpr double kLeastExtent = 0.1, kMostExtent = 4;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// The end in the frame of its last rib: x across, in half widths, and t forward, in half widths.
struct EndFrame {
  PicturePoint middle, across, forward;
  double half = 1;
  explicit EndFrame(const EndSite& site) {
    const CurveLayout& layout = site.curves.layout;
    const int rib = site.atStart ? 0 : layout.ribs - 1;
    middle = (site.left + site.right) / 2;
    half = std::max(1.0, distance(site.left, site.right) / 2);
    across = normalized(site.left - site.right);
    const int out = site.atStart ? layout.startFan(layout.fan / 2) : layout.endFan(layout.fan / 2);
    const PicturePoint base = site.curves.point(layout.left(rib), 0);
    const int last = std::max(0, site.curves.reached[index(out)] - 1);
    const PicturePoint far = site.curves.point(out, last);
    forward = {across.y, -across.x};
    if (dot(forward, far - base) < 0) forward = forward * -1.0;
  }
  double x(PicturePoint p) const { return std::abs(dot(p - middle, across)) / half; }
  double t(PicturePoint p) const { return std::max(0.0, dot(p - middle, forward) / half); }
};

bool outside(EndShape shape, double x, double t) {
  switch (shape) {
    case EndShape::Round:
      return x * x + t * t >= 1;
    case EndShape::Flat:
      return std::max(x, t) >= 1;
    case EndShape::Pointed:
      return x + t >= 1;
  }
  return true;
}

// The fan's curves from the left rib round to the right one, both included.
int fanCurve(const EndSite& site, int i) {
  const CurveLayout& layout = site.curves.layout;
  const int rib = site.atStart ? 0 : layout.ribs - 1;
  if (i == 0) return layout.left(rib);
  if (i == layout.fan + 1) return layout.right(rib);
  return site.atStart ? layout.startFan(i - 1) : layout.endFan(i - 1);
}

// Label at which a curve leaves the shape; its last one where it never does.
int crossing(const EndSite& site, const EndFrame& frame, const EndGuess& guess, int curve) {
  const int reached = site.curves.reached[index(curve)];
  for (int k = 1; k < reached; ++k) {
    const PicturePoint p = site.curves.point(curve, k);
    if (outside(guess.shape, frame.x(p), frame.t(p) / guess.extent)) return k;
  }
  return std::max(0, reached - 1);
}

// What an end costs that is unusually long or short, and what a shape costs that is rarer than round.
constexpr double kPriceOfLength = 0.5, kPriceOfFlat = 0.2, kPriceOfPoint = 0.5;
// Usual extents, in half widths.
constexpr double kRoundExtent = 1, kStraightExtent = 0.7;

double priceOf(const EndGuess& guess) {
  const bool round = guess.shape == EndShape::Round;
  const double usual = round ? kRoundExtent : kStraightExtent;
  const double price = kPriceOfLength * std::abs(std::log(guess.extent / usual));
  if (round) return price;
  return price + (guess.shape == EndShape::Flat ? kPriceOfFlat : kPriceOfPoint);
}

// One side's chain over the fan's curves. Places are shares of the guessed shape; between neighbours
// lies their part of a half circle.
void fillChain(const EndSite& site, const EndFrame& frame, const EndGuess& guess,
               LengthProblem& p) {
  const GradientCurves& curves = site.curves;
  p.ribs = curves.layout.fan + 2;
  p.levels = curves.levels;
  p.neighbourWeight = site.neighbourWeight;
  const std::size_t count = index(p.levels);
  p.left.unary.assign(index(p.ribs) * count, kUnreachable);
  p.left.place.resize(p.left.unary.size());
  p.left.spacing.assign(index(p.ribs - 1),
                        std::numbers::pi_v<float> / static_cast<float>(p.ribs - 1));
  for (int i = 0; i < p.ribs; ++i) {
    const int curve = fanCurve(site, i), reached = curves.reached[index(curve)];
    const int fixed = i == 0 ? site.leftLabel : i == p.ribs - 1 ? site.rightLabel : -1;
    const int wanted = fixed >= 0 ? fixed : crossing(site, frame, guess, curve);
    const float length = std::max(1e-3f, curves.along[curves.at(curve, wanted)]);
    float place = 0;
    for (int k = 0; k < p.levels; ++k) {
      const std::size_t at = index(i) * count + index(k);
      const bool exists = k < reached;
      place = exists ? curves.along[curves.at(curve, k)] / length : place + 1;
      p.left.place[at] = place;
      if (!exists || (fixed >= 0 && k != fixed) || (k == 0 && reached > 1 && fixed != 0)) continue;
      p.left.unary[at] = site.costs[curves.at(curve, k)] + kCapWeight * std::abs(place - 1);
    }
  }
}

// The outline with the two corners of a flat end, each after the points on its side that lie clearly
// before the end's level.
std::vector<PicturePoint> withCorners(const EndSite& site, const EndFrame& frame, double extent,
                                      const std::vector<PicturePoint>& outline) {
  constexpr double kBefore = 0.85;
  const PicturePoint on = frame.forward * (extent * frame.half);
  const auto before = [&](PicturePoint p) { return frame.t(p) < kBefore * extent; };
  const auto middle = outline.begin() + static_cast<std::ptrdiff_t>(outline.size() / 2);
  const auto left = std::find_if_not(outline.begin(), middle, before);
  const auto right =
      std::find_if_not(outline.rbegin(), std::make_reverse_iterator(middle), before).base();
  std::vector<PicturePoint> out;
  out.reserve(outline.size() + 2);
  out.assign(outline.begin(), left);
  out.push_back(site.left + on);
  out.insert(out.end(), left, right);
  out.push_back(site.right + on);
  out.insert(out.end(), right, outline.end());
  return out;
}

}  // namespace

EndGuess guessEnd(const EndSite& site) {
  const EndFrame frame(site);
  const int fan = site.curves.layout.fan;
  std::array<double, kExtents> extents, costs;
  for (int e = 0; e < kExtents; ++e) {
    const double share = static_cast<double>(e) / (kExtents - 1);
    extents[index(e)] = kLeastExtent * std::pow(kMostExtent / kLeastExtent, share);
  }
  EndGuess best;
  double least = std::numeric_limits<double>::infinity();
  for (const EndShape shape : {EndShape::Round, EndShape::Flat, EndShape::Pointed}) {
    for (std::size_t e = 0; e < costs.size(); ++e) costs[e] = priceOf({shape, extents[e]});
    for (int i = 1; i <= fan; ++i) {
      const int curve = fanCurve(site, i), reached = site.curves.reached[index(curve)];
      // The farther a shape goes, the later a curve leaves it.
      int k = 1;
      for (std::size_t e = 0; e < costs.size(); ++e) {
        for (; k < reached; ++k) {
          const PicturePoint p = site.curves.point(curve, k);
          if (outside(shape, frame.x(p), frame.t(p) / extents[e])) break;
        }
        const int label = k < reached ? k : std::max(0, reached - 1);
        costs[e] += static_cast<double>(site.costs[site.curves.at(curve, label)]);
      }
    }
    for (std::size_t e = 0; e < costs.size(); ++e) {
      if (costs[e] >= least) continue;
      least = costs[e];
      best = {shape, extents[e]};
    }
  }
  return best;
}

EndFan followEnd(const EndSite& site, LengthWorkspace& workspace) {
  const EndFrame frame(site);
  const EndGuess guess = guessEnd(site);
  LengthProblem& chain = workspace.end.chain;
  fillChain(site, frame, guess, chain);
  std::vector<int>& labels = workspace.end.labels;
  optimalChain(chain, chain.left, chain.left.unary, workspace, labels);
  std::vector<PicturePoint>& points = workspace.end.points;
  points.clear();
  for (int i = 1; i + 1 < chain.ribs; ++i) {
    const int curve = fanCurve(site, i);
    const double along = site.curves.along[site.curves.at(curve, labels[index(i)])];
    points.push_back(site.curves.pointAlong(
        curve, site.edges ? middleOfLine(site.curves, *site.edges, curve, along) : along));
  }
  if (guess.shape == EndShape::Flat) return {withCorners(site, frame, guess.extent, points)};
  return {points};
}

}  // namespace spineloft::ribs
