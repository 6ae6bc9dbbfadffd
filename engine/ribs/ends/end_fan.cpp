#include "engine/ribs/ends/end_fan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <span>

namespace spineloft::ribs {
namespace {

// How strongly a cap is held to its guessed shape, against evidence that spans about 1.
constexpr float kCapWeight = 0.5f;
// Extents that are tried, in half widths, evenly by ratio.
constexpr int kExtents = 24;
constexpr double kLeastExtent = 0.1, kMostExtent = 4;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// The end in the frame of the two ribs at which it begins: x across and t forward from between their ends, in
// halves of their distance. The last ribs of a wide part bend round its end: the stroke stops well
// before them then, at t < 0, and the part may end before them too.
struct EndFrame {
  PicturePoint middle, across, forward;
  double half = 1, stroke = 0, unit = 1;
  explicit EndFrame(const EndSite& site) {
    const CurveLayout& layout = site.curves.layout;
    middle = (site.left + site.right) / 2;
    half = std::max(1.0, distance(site.left, site.right) / 2);
    across = normalized(site.left - site.right);
    const int out = site.atStart ? layout.startFan(layout.fan / 2) : layout.endFan(layout.fan / 2);
    const PicturePoint stop = site.curves.point(out, 0);
    const int last = std::max(0, site.curves.reached[index(out)] - 1);
    const PicturePoint far = site.curves.point(out, last);
    forward = {across.y, -across.x};
    if (dot(forward, far - stop) < 0) forward = forward * -1.0;
    stroke = std::min(0.0, t(stop));
    unit = site.halfWidth / half;
  }
  double x(PicturePoint p) const { return std::abs(dot(p - middle, across)) / half; }
  double t(PicturePoint p) const { return dot(p - middle, forward) / half; }
  double tip(double extent) const { return stroke + extent * unit; }
};

// How far a shape goes at x, as a share of what it does in the middle.
double reachAt(EndShape shape, double x) {
  switch (shape) {
    case EndShape::Round:
      return std::sqrt(1 - x * x);
    case EndShape::Blunt:
      return std::sqrt(std::sqrt(1 - x * x * x * x));
    case EndShape::Flat:
      return 1;
    case EndShape::Pointed:
      return 1 - x;
  }
  return 0;
}

bool outside(const EndFrame& frame, EndShape shape, double tip, PicturePoint p) {
  const double x = frame.x(p);
  return x >= 1 || frame.t(p) >= tip * reachAt(shape, x);
}

// The end's curves but for the two at which it begins.
int curvesOf(const EndSite& site) { return site.freeLeft + site.curves.layout.fan + site.freeRight; }

// The end's curves from the left rib at which it begins round to the right one, both included.
int curveOf(const EndSite& site, int i) {
  const CurveLayout& layout = site.curves.layout;
  const auto rib = [&](int inwards) { return site.atStart ? inwards : layout.ribs - 1 - inwards; };
  if (i <= site.freeLeft) return layout.left(rib(site.freeLeft - i));
  const int fan = i - site.freeLeft - 1;
  if (fan >= layout.fan) return layout.right(rib(fan - layout.fan));
  return site.atStart ? layout.startFan(fan) : layout.endFan(fan);
}

// Label at which a curve leaves the shape; its last one where it never does.
int crossing(const EndSite& site, const EndFrame& frame, const EndGuess& guess, int curve) {
  const int reached = site.curves.reached[index(curve)];
  const double tip = frame.tip(guess.extent);
  for (int k = 1; k < reached; ++k) {
    if (outside(frame, guess.shape, tip, site.curves.point(curve, k))) return k;
  }
  return std::max(0, reached - 1);
}

// What every factor of e costs by which an end is shorter or longer than usual, and what a shape costs that
// is rarer than round.
constexpr double kPriceOfLength = 1, kPriceOfBlunt = 0.1, kPriceOfFlat = 0.2, kPriceOfPoint = 0.5;
// Usual extents, in half widths.
constexpr double kRoundExtent = 1, kStraightExtent = 0.7;

double priceOf(const EndGuess& guess) {
  const auto price = [&](double usual, double shape) {
    return shape + kPriceOfLength * std::abs(std::log(guess.extent / usual));
  };
  switch (guess.shape) {
    case EndShape::Round:
      return price(kRoundExtent, 0);
    case EndShape::Blunt:
      return price(kRoundExtent, kPriceOfBlunt);
    case EndShape::Flat:
      return price(kStraightExtent, kPriceOfFlat);
    case EndShape::Pointed:
      return price(kStraightExtent, kPriceOfPoint);
  }
  return 0;
}

// The chain over the end's curves. Places are shares of the guessed shape; between neighbours
// lies their part of a half circle.
void fillChain(const EndSite& site, const EndFrame& frame, const EndGuess& guess, LengthProblem& p) {
  const GradientCurves& curves = site.curves;
  p.ribs = curvesOf(site) + 2;
  p.levels = curves.levels;
  p.neighbourWeight = site.neighbourWeight;
  const std::size_t count = index(p.levels);
  p.left.unary.assign(index(p.ribs) * count, kUnreachable);
  p.left.place.resize(p.left.unary.size());
  p.left.spacing.assign(index(p.ribs - 1), std::numbers::pi_v<float> / static_cast<float>(p.ribs - 1));
  for (int i = 0; i < p.ribs; ++i) {
    const int curve = curveOf(site, i), reached = curves.reached[index(curve)];
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

// The outline, which comes from `from` and goes on to `to`, with the two corners of a flat end that goes as far as
// `tip`: each after the points on its side that lie clearly before the end's level, straight ahead of the last of them,
// for a corner farther out than the side would be the brim of a hat.
void withCorners(const EndFrame& frame, double tip, PicturePoint from, std::span<const PicturePoint> outline,
                 PicturePoint to, std::vector<PicturePoint>& out) {
  constexpr double kBefore = 0.85;
  if (!(tip > 0)) {
    out.assign(outline.begin(), outline.end());
    return;
  }
  const auto ahead = [&](PicturePoint p) { return p + frame.forward * ((tip - frame.t(p)) * frame.half); };
  const auto before = [&](PicturePoint p) { return frame.t(p) < kBefore * tip; };
  const auto middle = outline.begin() + static_cast<std::ptrdiff_t>(outline.size() / 2);
  const auto left = std::find_if_not(outline.begin(), middle, before);
  const auto right = std::find_if_not(outline.rbegin(), std::make_reverse_iterator(middle), before).base();
  out.reserve(outline.size() + 2);
  out.assign(outline.begin(), left);
  out.push_back(ahead(left == outline.begin() ? from : *(left - 1)));
  out.insert(out.end(), left, right);
  out.push_back(ahead(right == outline.end() ? to : *right));
  out.insert(out.end(), right, outline.end());
}

}  // namespace

EndGuess guessEnd(const EndSite& site) {
  const EndFrame frame(site);
  const int count = curvesOf(site);
  std::array<double, kExtents> extents, costs;
  for (int e = 0; e < kExtents; ++e) {
    const double share = static_cast<double>(e) / (kExtents - 1);
    extents[index(e)] = kLeastExtent * std::pow(kMostExtent / kLeastExtent, share);
  }
  EndGuess best;
  double least = std::numeric_limits<double>::infinity();
  for (const EndShape shape : {EndShape::Round, EndShape::Blunt, EndShape::Flat, EndShape::Pointed}) {
    for (std::size_t e = 0; e < costs.size(); ++e) costs[e] = priceOf({shape, extents[e]});
    for (int i = 1; i <= count; ++i) {
      const int curve = curveOf(site, i), reached = site.curves.reached[index(curve)];
      // The farther a shape goes, the later a curve leaves it.
      int k = 1;
      for (std::size_t e = 0; e < costs.size(); ++e) {
        const double tip = frame.tip(extents[e]);
        while (k < reached && !outside(frame, shape, tip, site.curves.point(curve, k))) ++k;
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

void followEnd(const EndSite& site, LengthWorkspace& workspace, EndOutline& outline) {
  outline.guess = guessEnd(site);
  outline.cost = priceOf(outline.guess);
  outline.labels.clear();
  outline.points.clear();
  LengthProblem& chain = workspace.end.chain;
  fillChain(site, EndFrame(site), outline.guess, chain);
  std::vector<int>& labels = workspace.end.labels;
  optimalChain(chain, chain.left, chain.left.unary, workspace, labels);
  for (int i = 1; i + 1 < chain.ribs; ++i) {
    const int curve = curveOf(site, i), label = labels[index(i)];
    outline.labels.push_back(label);
    outline.points.push_back(site.curves.point(curve, label));
    outline.cost += static_cast<double>(site.costs[site.curves.at(curve, label)]);
  }
}

void fanOf(const EndSite& site, const EndOutline& outline, EndFan& fan) {
  const std::span all(outline.points);
  const std::size_t first = index(site.freeLeft), count = index(site.curves.layout.fan);
  const std::span points = all.subspan(first, count);
  if (outline.guess.shape == EndShape::Flat) {
    const EndFrame frame(site);
    const PicturePoint from = first == 0 ? site.left : all[first - 1],
                       to = site.freeRight == 0 ? site.right : all[first + count];
    withCorners(frame, frame.tip(outline.guess.extent), from, points, to, fan.points);
  } else {
    fan.points.assign(points.begin(), points.end());
  }
}

}  // namespace spineloft::ribs
