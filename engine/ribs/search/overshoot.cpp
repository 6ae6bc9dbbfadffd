#include "engine/ribs/search/overshoot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/geometry/polyline.h"
#include "engine/ribs/search/rib_search.h"

namespace spineloft::ribs {
namespace {

// Shares of the lengths in the middle of the stroke: up to the first is certainly the object, from the second on
// certainly not.
constexpr float kSurelyInside = 0.8f, kSurelyOutside = 1.2f;
// What is seen along the spine is taken from so far on either side of it, in half widths.
constexpr double kNear = 0.3;
// Largest overshoot: in half widths, and as a share of the ribs.
constexpr double kFarthest = 3, kMostOfRibs = 0.4;
// Distance of the new end from the end of the object, in half widths, and at most this share of the spine.
constexpr double kBeforeEnd = 0.3, kMostBeforeEnd = 0.12;
// If less than this share of the spine would be left, nothing is cut.
constexpr double kLeastLeft = 0.3;

// Colours: log-odds beyond and on the thing, how far apart they have to be, and the least number of ribs that
// are beyond. What is above kBalance, summed up in half widths, says how sure it is.
constexpr double kBalance = 0.3, kBackground = 0.4, kOwn = -0.2, kApart = 1.3, kLeastSum = 0.05;
constexpr int kLeastRibs = 2;
// Lines: nearness to an edge that is a crossing, and what share of the ribs' ends stands on edges beyond and behind.
constexpr double kCrossing = 0.3, kNothing = 0.3, kSomething = 0.45;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// What is seen along the spine, by rib.
struct Along {
  std::vector<double> logOdds;  // mean log-odds
  std::vector<double> edge;     // mean nearness to an edge
  std::vector<double> support;  // nearness of the ribs' two ends to an edge
  int ribs() const { return static_cast<int>(logOdds.size()); }
};

// The same from one end inwards.
struct FromEnd {
  const Along& along;
  bool start;
  std::size_t at(int inwards) const { return index(start ? inwards : along.ribs() - 1 - inwards); }
  double mean(const std::vector<double>& values, int first, int last) const {
    double sum = 0;
    for (int i = first; i < last; ++i) sum += values[at(i)];
    return last > first ? sum / (last - first) : 0;
  }
};

double middleHalfWidth(const RibSet& set) {
  const std::size_t quarter = set.ribs.size() / 4;
  std::vector<double> halves;
  for (std::size_t i = quarter; i < set.ribs.size() - quarter; ++i)
    halves.push_back(distance(set.ribs[i].left, set.ribs[i].right) / 2);
  const auto middle = halves.begin() + static_cast<std::ptrdiff_t>(halves.size() / 2);
  std::nth_element(halves.begin(), middle, halves.end());
  return std::max(2.0, *middle);
}

// Log-odds of the picture's colours against the inside of the middle's ribs.
const std::vector<float>& logOddsToMiddle(double half, Search& s) {
  const CurveLayout& layout = s.curves.layout;
  const auto curves = index(layout.total());
  const int ribs = s.problem.ribs, quarter = ribs / 4;
  KnownReach known;
  known.inside.assign(curves, 0.f);
  known.outside.assign(curves, std::numeric_limits<float>::infinity());
  for (int i = 0; i < ribs; ++i) {
    for (const bool leftSide : {true, false}) {
      const std::size_t curve = index(layout.sideOf(i, leftSide));
      const int label = (leftSide ? s.labels.left : s.labels.right)[index(i)];
      const float length = s.curves.along[s.curves.at(static_cast<int>(curve), label)];
      if (i >= quarter && i < ribs - quarter) known.inside[curve] = kSurelyInside * length;
      known.outside[curve] = kSurelyOutside * std::max(length, static_cast<float>(half));
    }
  }
  BoundaryScratch& scratch = s.boundary.scratch;
  spineLogOdds(s.curves, s.strip, known, scratch.colours, scratch.logOdds);
  return scratch.logOdds;
}

Along lookAlong(double half, Search& s) {
  const std::vector<float>& logOdds = logOddsToMiddle(half, s);
  const int ribs = s.problem.ribs;
  Along along;
  for (int i = 0; i < ribs; ++i) {
    double odds = 0, edge = 0, support = 0;
    int count = 0;
    for (const bool leftSide : {true, false}) {
      const int curve = s.curves.layout.sideOf(i, leftSide);
      const int label = (leftSide ? s.labels.left : s.labels.right)[index(i)];
      support += static_cast<double>(s.strip.proximity[s.curves.at(curve, label)]) / 2;
      for (int k = 0; k < s.curves.reached[index(curve)]; ++k, ++count) {
        const std::size_t at = s.curves.at(curve, k);
        if (static_cast<double>(s.curves.along[at]) > kNear * half) break;
        odds += static_cast<double>(logOdds[at]);
        edge += static_cast<double>(s.strip.proximity[at]);
      }
    }
    along.logOdds.push_back(odds / std::max(1, count));
    along.edge.push_back(edge / std::max(1, count));
    along.support.push_back(support);
  }
  return along;
}

// Number of ribs of an end that lie beyond the object, by their colours. `share`: the spacing of ribs in half widths.
int beyondByColour(const FromEnd& end, int most, double share) {
  const std::vector<double>& logOdds = end.along.logOdds;
  double sum = 0, best = 0;
  int cut = 0;
  for (int i = 0; i < most; ++i) {
    sum += (logOdds[end.at(i)] - kBalance) * share;
    if (sum <= best) continue;
    best = sum;
    cut = i + 1;
  }
  const double out = end.mean(logOdds, 0, cut);
  const double in = end.mean(logOdds, cut, std::min(end.along.ribs(), cut + end.along.ribs() / 6));
  const bool clear = out > kBackground && in < kOwn && out - in > kApart;
  return clear && cut >= kLeastRibs && best > kLeastSum ? cut : 0;
}

// The same, by a drawn line that closes the object.
int beyondByLine(const FromEnd& end, int most) {
  const Along& along = end.along;
  int line = 0;
  while (line < most && along.edge[end.at(line)] < kCrossing) ++line;
  while (line + 1 < most && along.edge[end.at(line + 1)] > along.edge[end.at(line)]) ++line;
  // A line has a width: one rib before it and two behind are neither here nor there.
  const int before = line - 1, behind = line + 3, depth = std::max(1, along.ribs() / 8);
  if (line >= most || before < 1 || behind + depth > along.ribs()) return 0;
  const bool nothing = end.mean(along.support, 0, before) < kNothing;
  const bool something = end.mean(along.support, behind, behind + depth) > kSomething;
  // Here the colours decide nothing, or agree.
  const double out = end.mean(along.logOdds, 0, before), in = end.mean(along.logOdds, behind, behind + depth);
  return nothing && something && out > -kBalance && out > in - kBalance ? line : 0;
}

// A place on a polyline and its segment.
struct Spot {
  std::size_t segment = 0;
  PicturePoint at;
};

// Where a stroke comes nearest to a point of its spine, which lies at about the same share of the length: a
// stroke may pass it more than once.
Spot spotOn(std::span<const PicturePoint> stroke, PicturePoint p, double shareOfLength) {
  constexpr double kAbout = 0.2;
  const std::vector<double> s = geometry::arcLengths(stroke);
  Spot best{0, stroke.front()};
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < stroke.size(); ++i) {
    const PicturePoint step = stroke[i + 1] - stroke[i];
    const double squared = dot(step, step);
    const double t = squared > 0 ? std::clamp(dot(p - stroke[i], step) / squared, 0.0, 1.0) : 0;
    const double place = (s[i] + t * (s[i + 1] - s[i])) / s.back();
    const PicturePoint at = lerp(stroke[i], stroke[i + 1], t);
    if (std::abs(place - shareOfLength) > kAbout || distance(at, p) >= nearest) continue;
    nearest = distance(at, p);
    best = {i, at};
  }
  return best;
}

}  // namespace

Result<SpineStretch> stretchOnThing(const Spine& spine, const PictureEvidence& picture, const RibParams& params,
                                    RibWorkspace& memory, RibSet& set) {
  Search& s = memory.search();
  const Status found = searchRibs(spine, picture, params, Progress(), s, set);
  if (!found.ok()) return found.failure();
  constexpr int kFewest = 16;
  const int ribs = s.problem.ribs;
  if (picture.edges.empty() || ribs < kFewest) return SpineStretch{};
  const double half = middleHalfWidth(set), length = s.field.length();
  const double share = length / (ribs - 1) / half;
  const int most = static_cast<int>(std::min(kMostOfRibs * ribs, kFarthest / share + 2));
  const Along along = lookAlong(half, s);
  const auto cutOf = [&](bool start) {
    const FromEnd end{along, start};
    const int byColour = beyondByColour(end, most, share);
    const int cut = byColour > 0 ? byColour : beyondByLine(end, most);
    if (cut == 0) return 0.0;
    return static_cast<double>(cut) / (ribs - 1) + std::min(kBeforeEnd * half / length, kMostBeforeEnd);
  };
  const SpineStretch stretch{cutOf(true), 1 - cutOf(false)};
  return stretch.to - stretch.from < kLeastLeft ? SpineStretch{} : stretch;
}

std::vector<PicturePoint> strokeOnThing(std::span<const PicturePoint> stroke, const PictureEvidence& picture,
                                        const SpineParams& spine, const RibParams& ribs, RibWorkspace& memory,
                                        std::optional<TracedStroke>& whole) {
  std::vector<PicturePoint> kept(stroke.begin(), stroke.end());
  whole.reset();
  Result<Spine> cleaned = cleanSpine(stroke, picture.size, spine);
  if (!cleaned || picture.edges.empty()) return kept;
  TracedStroke traced{std::move(cleaned).value(), {}};
  const Result<SpineStretch> found = stretchOnThing(traced.spine, picture, ribs, memory, traced.ribs);
  if (!found) return kept;
  const std::span<const PicturePoint> points = traced.spine.points;
  const std::vector<double> s = geometry::arcLengths(points);
  const auto spotAt = [&](double share) {
    return spotOn(stroke, geometry::pointAt(points, std::span<const double>(s), share * s.back()), share);
  };
  const auto [from, to] = found.value();
  const Spot first = spotAt(from), last = spotAt(to);
  if (found.value().whole() || first.segment > last.segment) {
    whole = std::move(traced);
    return kept;
  }
  kept.clear();
  if (from > 0) kept.push_back(first.at);
  const auto at = [&](std::size_t i) { return stroke.begin() + static_cast<std::ptrdiff_t>(i); };
  kept.insert(kept.end(), at(from > 0 ? first.segment + 1 : 0), at(to < 1 ? last.segment + 1 : stroke.size()));
  if (to < 1) kept.push_back(last.at);
  return kept;
}

std::vector<PicturePoint> strokeOnThing(std::span<const PicturePoint> stroke, const PictureEvidence& picture,
                                        const SpineParams& spine, const RibParams& ribs) {
  RibWorkspace memory;
  std::optional<TracedStroke> whole;
  return strokeOnThing(stroke, picture, spine, ribs, memory, whole);
}

}  // namespace spineloft::ribs
