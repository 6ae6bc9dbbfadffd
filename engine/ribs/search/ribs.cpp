#include "engine/ribs/search/ribs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/ribs/search/rib_search.h"

namespace spineloft::ribs {
namespace {

// The number of ribs for which the weights were chosen. Neighbouring ribs see the same edges, so three times the ribs
// are not three times the evidence.
constexpr double kReferenceRibs = 100;
// Curves of the fan strictly between the outermost ribs of an end.
constexpr int kFanCurves = 11;
// Largest half width, as a share of the length of the spine.
constexpr double kFarthestPerLength = 1.0;
constexpr double kFarthestPerSide = 0.75;
// Half width without a picture, or where it shows nothing, as a share of the spine's length; and how narrow the
// probability about it is.
constexpr double kDefaultHalfWidth = 0.1;
constexpr double kPriorSteepness = 4;
// The share of the likely ends that lies on edges from which on the picture alone counts. 98 of 100 strokes through
// things have more.
constexpr double kShownEnough = 0.15;
// Upper bound of the opposite cost of one rib. Where a stroke wanders, or the hypothesis is too narrow, the evidence
// on both sides must outweigh the symmetry.
constexpr double kMostUnequal = 0.55;
std::size_t index(int i) { return static_cast<std::size_t>(i); }

void chooseLevels(const image::EdgeMap& edges, image::Size picture, Search& s) {
  const D2Field& field = s.field;
  const RibParams& params = s.params;
  const double diagonal = std::hypot(picture.width, picture.height);
  // A part that shows both its sides is at most as wide as the picture's shorter side, and a stroke
  // has at most three quarters of that on one side of it.
  const double widest = kFarthestPerSide * std::min(picture.width, picture.height);
  const double farthest = std::min({params.maxLevelShare * diagonal, widest, kFarthestPerLength * field.length()});
  const double step = edges.empty() ? 1.0 : std::max(edges.scaleX, edges.scaleY);
  makeLevels(params.levels, step, farthest, field.length(), s.levels);
}

// Of every level, without knowing the picture.
void widthPrior(const Search& s, std::vector<float>& prior) {
  const double half = kDefaultHalfWidth * s.field.length();
  double sum = 0;
  prior.assign(s.levels.size(), 0.f);
  for (std::size_t k = 1; k < prior.size(); ++k) {
    prior[k] = static_cast<float>(std::exp(-kPriorSteepness * std::abs(s.levels.radius[k] / half - 1)));
    sum += static_cast<double>(prior[k]);
  }
  for (float& p : prior) p /= static_cast<float>(sum);
}

}  // namespace

double shareOfRib(const Search& s) { return kReferenceRibs / s.curves.layout.ribs; }

void findEvidence(Search& s) {
  if (s.edges == nullptr) {
    s.boundary.clear(s.curves.x.size());
  } else {
    findBoundary(s.curves, s.strip, builtInNetwork(), s.params.evidence, s.boundary);
  }
  const double shown = shownShare(s.boundary);
  if (shown < kShownEnough) {
    widthPrior(s, s.prior);
    mixPrior(s.curves, s.prior, 1 - shown / kShownEnough, s.params.evidence, s.boundary);
  }
  const auto weight = static_cast<float>(s.params.evidence.weight * shareOfRib(s));
  s.costs.resize(s.boundary.costs.size());
  for (std::size_t i = 0; i < s.costs.size(); ++i) s.costs[i] = weight * s.boundary.costs[i];
}

namespace {

// From costs of every curve and level to those of one side's chain.
void fillSide(const std::vector<float>& costs, bool leftSide, Search& s) {
  SideCosts& side = leftSide ? s.problem.left : s.problem.right;
  const int ribs = s.problem.ribs, count = s.problem.levels;
  side.unary.assign(index(ribs) * index(count), kUnreachable);
  side.place.resize(side.unary.size());
  for (int i = 0; i < ribs; ++i) {
    const int curve = s.curves.layout.sideOf(i, leftSide);
    const int reached = s.curves.reached[index(curve)];
    for (int k = 0; k < count; ++k) {
      const std::size_t at = index(i) * index(count) + index(k);
      side.place[at] = k < reached ? s.curves.along[s.curves.at(curve, k)] : side.place[at - 1] + 1;
      // Label 0 is the spine itself: only for a curve that has nowhere else to go.
      if (k >= reached || (k == 0 && reached > 1)) continue;
      side.unary[at] = costs[s.curves.at(curve, k)];
    }
  }
}

void fillSpacing(Search& s) {
  for (SideCosts* side : {&s.problem.left, &s.problem.right}) {
    side->spacing.resize(index(s.problem.ribs - 1));
    for (int i = 1; i < s.problem.ribs; ++i) {
      side->spacing[index(i - 1)] =
          static_cast<float>(distance(s.spine.points[index(i - 1)], s.spine.points[index(i)]));
    }
  }
}

}  // namespace

void fillProblem(Search& s) {
  s.problem.ribs = s.curves.layout.ribs;
  s.problem.levels = s.curves.levels;
  s.problem.neighbourWeight = static_cast<float>(s.params.neighbourWeight * shareOfRib(s));
  s.problem.neighbourFreedom = static_cast<float>(s.params.neighbourFreedom);
  s.problem.neighbourCap = static_cast<float>(s.params.neighbourCap);
  fillSide(s.costs, true, s);
  fillSide(s.costs, false, s);
  fillSpacing(s);
}

void fitWidthHypotheses(Search& s) {
  const double pixel = s.levels.radius[1];
  fitWidthHypotheses(s.problem, 2 * pixel, s.params.medialOffsetCost, s.workspace, s.parts);
}

void assumeWidth(const WidthHypothesis& even, Search& s) {
  const double pixel = s.levels.radius[1];
  s.problem.medialOffset = static_cast<float>(even.medialOffset);
  s.problem.medialOffsetCap = static_cast<float>(kMostUnequal * shareOfRib(s));
  s.problem.medialOffsetScale.clear();
  for (float width : even.width) {
    const double scale = 2 * s.params.oppositeWeight * shareOfRib(s) / std::max(4 * pixel, static_cast<double>(width));
    s.problem.medialOffsetScale.push_back(static_cast<float>(scale));
  }
}

void bestLabels(Search& s) {
  double least = std::numeric_limits<double>::infinity();
  std::size_t chosen = 0;
  for (std::size_t i = 0; i < s.parts.count; ++i) {
    assumeWidth(s.parts.all[i], s);
    if (!findLabels(s.problem, least, s.workspace, s.trial)) continue;
    const double energy = energyOf(s.problem, s.trial).total();
    if (energy >= least) continue;
    least = energy;
    chosen = i;
    s.labels = s.trial;
  }
  if (chosen + 1 != s.parts.count) assumeWidth(s.parts.all[chosen], s);
}

Status beginSearch(const Spine& spine, const PictureEvidence& picture, const RibParams& params, Search& s) {
  const image::EdgeMap& edges = picture.edges;
  if (!inRange(params)) return Error::ValueOutOfRange;
  if (spine.points.size() < 2) return Error::StrokeTooShort;
  s.spine = spine;
  s.edges = edges.empty() ? nullptr : &edges;
  s.params = params;
  s.field.assign(spine.points);
  if (!(s.field.length() > 0)) return Error::StrokeTooShort;
  chooseLevels(edges, picture.size, s);
  traceCurves(spine, s.field, s.levels, kFanCurves, picture.size, s.curves);
  return Done{};
}

Status searchLabels(const Spine& spine, const PictureEvidence& picture, const RibParams& params,
                    const Progress& progress, Search& s) {
  if (!progress.advance(0.05)) return Error::Cancelled;
  if (Status begun = beginSearch(spine, picture, params, s); !begun.ok()) return begun;
  if (!progress.advance(0.4)) return Error::Cancelled;
  if (!picture.edges.empty()) unwrapImage(s.curves, picture.edges, picture.ignored, s.strip);
  findEvidence(s);
  fillProblem(s);
  fitWidthHypotheses(s);
  if (!progress.advance(0.5)) return Error::Cancelled;
  bestLabels(s);
  if (!progress.advance(0.9)) return Error::Cancelled;
  return Done{};
}

Status searchRibs(const Spine& spine, const PictureEvidence& picture, const RibParams& params, const Progress& progress,
                  Search& s, RibSet& set) {
  const Status found = searchLabels(spine, picture, params, progress, s);
  if (!found.ok()) return found;
  readRibs(true, s, set);
  progress.advance(1);
  return Done{};
}

RibWorkspace::RibWorkspace() = default;
RibWorkspace::~RibWorkspace() = default;
RibWorkspace::RibWorkspace(RibWorkspace&&) noexcept = default;
RibWorkspace& RibWorkspace::operator=(RibWorkspace&&) noexcept = default;

RibWorkspace::Search& RibWorkspace::search() {
  if (!search_) search_ = std::make_unique<Search>();
  return *search_;
}

Result<RibSet> traceRibs(const Spine& spine, const PictureEvidence& picture, const RibParams& params,
                         const Progress& progress) {
  RibWorkspace memory;
  return traceRibs(spine, picture, params, progress, memory);
}

Result<RibSet> traceRibs(const Spine& spine, const PictureEvidence& picture, const RibParams& params,
                         const Progress& progress, RibWorkspace& memory) {
  RibSet set;
  const Status found = searchRibs(spine, picture, params, progress, memory.search(), set);
  if (!found.ok()) return found.failure();
  return set;
}

}  // namespace spineloft::ribs
