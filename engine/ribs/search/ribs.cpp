#include "engine/ribs/search/ribs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "engine/base/lanes.h"
#include "engine/ribs/evidence/edge_strength.h"
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
// Half width without a picture, or where it shows nothing at all, as a share of the spine's length.
constexpr double kDefaultHalfWidth = 0.1;
// Beyond this multiple of the length of a rib the picture certainly shows the surroundings.
constexpr float kSurelyOutside = 1.15f;
// Pass 3: a length may change by this factor at no cost; each further factor of e costs kPriceOfChange.
constexpr float kMostChange = 1.5f;
constexpr double kPriceOfChange = 3;
// Pass 3 holds the ends to a line that is stiffer than the final fairing by this factor. Its opposite term weighs
// less than in passes 1 and 2, because the medial offset varies along a stroke.
constexpr double kStiffer = 40;
constexpr float kOppositeShare = 0.7f;
// Upper bound of the opposite cost of one rib. Where a stroke wanders, or the hypothesis is too narrow, the evidence
// on both sides must outweigh the symmetry.
constexpr double kMostUnequal = 0.55;
// Pass 3: weight of the evidence of a curve whose end stands on no edge, where an end on as strong an edge as its
// neighbours has 1.
constexpr float kLeastWeight = 0.3f;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

void chooseLevels(const image::EdgeMap& edges, image::Size picture, Search& s) {
  const D2Field& field = s.field;
  const RibParams& params = s.params;
  const double diagonal = std::hypot(picture.width, picture.height);
  // A part that shows both its sides is at most as wide as the picture's shorter side, and a stroke
  // has at most three quarters of that on one side of it.
  const double widest = kFarthestPerSide * std::min(picture.width, picture.height);
  const double farthest =
      std::min({params.maxLevelShare * diagonal, widest, kFarthestPerLength * field.length(), s.farthest});
  const double step = edges.empty() ? 1.0 : std::max(edges.scaleX, edges.scaleY);
  makeLevels(params.levels, step, farthest, field.length(), s.levels);
}

// Costs without a picture: they grow with the distance from the default half width.
void defaultCosts(Search& s) {
  s.costs.resize(s.curves.x.size());
  s.support.assign(s.costs.size(), 0.f);
  const double half = kDefaultHalfWidth * s.field.length();
  for (std::size_t i = 0; i < s.costs.size(); ++i) {
    s.costs[i] = static_cast<float>(std::abs(s.levels.radius[i % s.levels.size()] / half - 1));
  }
}

void weighTerms(const EvidenceParams& params, Search& s) {
  boundaryCosts(s.curves, s.strip, s.terms, params, s.costs);
  const double weight = s.params.evidence.weight * shareOfRib(s);
  for (float& cost : s.costs) cost *= static_cast<float>(weight);
}

}  // namespace

double shareOfRib(const Search& s) { return kReferenceRibs / s.curves.layout.ribs; }

void findContours(Search& s) {
  contourTerms(s.curves, s.strip, s.params.evidence, s.terms);
  s.support.resize(s.terms.contrast.size());
  for (std::size_t i = 0; i < s.support.size(); ++i) {
    s.support[i] = std::max(s.terms.contrast[i], s.strip.proximity[i]);
  }
}

void firstEvidence(Search& s) {
  colourTerms(s.curves, s.strip, {}, s.terms);
  weighTerms(s.params.evidence, s);
}

namespace {

// Pass 2: the evidence with the colours of the inner part of the hypothesis as the object's.
void secondEvidence(const WidthHypothesis& even, Search& s) {
  const auto share = static_cast<float>(s.params.evidence.knownShare);
  s.known.inside.assign(index(s.curves.layout.total()), 0.f);
  s.known.outside.clear();
  for (int i = 0; i < s.curves.layout.ribs; ++i) {
    const float half = share * even.width[index(i)] / 2;
    const auto lean = static_cast<float>(even.lean);
    s.known.inside[index(s.curves.layout.left(i))] = half * (1 + lean);
    s.known.inside[index(s.curves.layout.right(i))] = half * (1 - lean);
  }
  colourTerms(s.curves, s.strip, s.known, s.terms);
  weighTerms(s.params.evidence, s);
}

// From costs of every curve and level to those of one side's chain.
void fillSide(const std::vector<float>& costs, bool leftSide, Search& s) {
  SideCosts& side = leftSide ? s.problem.left : s.problem.right;
  const int ribs = s.problem.ribs, count = s.problem.levels;
  const double middle = 0.5 * (count - 1);
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
      const double pull = s.params.priorWeight * std::abs(k - middle) / middle;
      side.unary[at] = costs[s.curves.at(curve, k)] + static_cast<float>(pull);
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

namespace {

// The spacing of neighbouring ends at the width of the hypothesis, at least that on the hull. In bends and round the
// ends curves diverge, and lengths may then differ by more from one rib to the next.
void spread(const WidthHypothesis& even, bool leftSide, Search& s) {
  SideCosts& side = leftSide ? s.problem.left : s.problem.right;
  const double factor = 0.5 * (leftSide ? 1 + even.lean : 1 - even.lean);
  const auto curveOf = [&](int i) { return s.curves.layout.sideOf(i, leftSide); };
  for (int i = 0; i + 1 < s.problem.ribs; ++i) {
    const int a = curveOf(i), b = curveOf(i + 1);
    const int most = std::min(s.curves.reached[index(a)], s.curves.reached[index(b)]) - 1;
    const double wanted = factor * static_cast<double>(even.width[index(i)]);
    int k = 0;
    while (k < most && static_cast<double>(s.curves.along[s.curves.at(a, k)]) < wanted) ++k;
    const double hull = distance(s.spine.points[index(i)], s.spine.points[index(i + 1)]);
    const double apart = distance(s.curves.point(a, k), s.curves.point(b, k));
    side.spacing[index(i)] = static_cast<float>(std::max(apart, hull));
  }
}

}  // namespace

void assumeWidth(const WidthHypothesis& even, Search& s) {
  spread(even, true, s);
  spread(even, false, s);
  const double pixel = s.levels.radius[1];
  s.problem.lean = static_cast<float>(even.lean);
  s.problem.medialOffsetCap = static_cast<float>(kMostUnequal * shareOfRib(s));
  s.problem.medialOffsetScale.clear();
  for (float width : even.width) {
    const double scale = 2 * s.params.oppositeWeight * shareOfRib(s) / std::max(4 * pixel, static_cast<double>(width));
    s.problem.medialOffsetScale.push_back(static_cast<float>(scale));
  }
}

void adoptHypothesis(std::size_t i, bool withColours, Search& s) {
  const WidthHypothesis& part = s.parts.all[i];
  assumeWidth(part, s);
  if (withColours) {
    secondEvidence(part, s);
    fillSide(s.costs, true, s);
    fillSide(s.costs, false, s);
  }
  s.contest.last = i;
}

void tryHypothesis(std::size_t i, bool withColours, Search& s) {
  adoptHypothesis(i, withColours, s);
  if (!findLabels(s.problem, s.contest.least, s.workspace, s.trial)) return;
  const double energy = energyOf(s.problem, s.trial).total();
  if (energy >= s.contest.least) return;
  s.contest.least = energy;
  s.contest.chosen = i;
  s.labels = s.trial;
}

void bestLabels(bool withColours, Search& s) {
  s.contest = {};
  for (std::size_t i = 0; i < s.parts.count; ++i) tryHypothesis(i, withColours, s);
  // States and fans are read from the evidence of the chosen hypothesis.
  if (s.contest.last != s.contest.chosen) adoptHypothesis(s.contest.chosen, withColours, s);
}

const std::vector<float>& strengthsOf(const std::vector<int>& labels, bool leftSide, Search& s) {
  const auto& differences = s.terms.scratch.differences;
  return edgeStrengths({s.curves, labels, leftSide}, s.edges ? std::span(differences) : std::span(differences).first(0),
                       s.strengths);
}

void stiffLengths(Search& s) {
  const LengthLabels& labels = s.labels;
  s.known.inside.assign(index(s.curves.layout.total()), 0.f);
  s.say.assign(s.known.inside.size(), 1.f);
  FairingParams stiff = s.params.fairing;
  stiff.stiffness *= kStiffer;
  for (const bool leftSide : {true, false}) {
    const std::vector<int>& side = leftSide ? labels.left : labels.right;
    const auto curveOf = [&](int i) { return s.curves.layout.sideOf(i, leftSide); };
    const std::vector<float>& strengths = strengthsOf(side, leftSide, s);
    s.lengths.length.clear();
    s.lengths.trust.clear();
    for (int i = 0; i < s.problem.ribs; ++i) {
      const std::size_t at = s.curves.at(curveOf(i), side[index(i)]);
      const auto support = static_cast<double>(s.support[at] * strengths[index(i)]);
      s.lengths.length.push_back(static_cast<double>(s.curves.along[at]));
      s.lengths.trust.push_back(support * support);
    }
    const std::vector<double>& fair = fairLengths(s.lengths, stiff, s.fairing);
    for (int i = 0; i < s.problem.ribs; ++i) {
      s.known.inside[index(curveOf(i))] = std::max(1.f, static_cast<float>(fair[index(i)]));
      s.say[index(curveOf(i))] = kLeastWeight + (1 - kLeastWeight) * strengths[index(i)];
    }
  }
}

void thirdEvidence(Search& s) {
  constexpr float kUnknown = std::numeric_limits<float>::infinity();
  s.known.outside.assign(s.known.inside.size(), kUnknown);
  const auto forRibs = [&](auto&& what) {
    for (int i = 0; i < s.curves.layout.ribs; ++i) {
      what(s.curves.layout.left(i));
      what(s.curves.layout.right(i));
    }
  };
  forRibs([&](int curve) { s.known.outside[index(curve)] = kSurelyOutside * s.known.inside[index(curve)]; });
  colourTerms(s.curves, s.strip, s.known, s.terms);
  // Local contrast amplifies the borders of shadows and halos; in this pass the colour terms replace it.
  EvidenceParams params = s.params.evidence;
  params.localContrastWeight = 0;
  weighTerms(params, s);
  const float most = std::log(kMostChange);
  const auto price = static_cast<float>(kPriceOfChange * shareOfRib(s));
  s.held.resize(s.costs.size());
  forRibs([&](int curve) {
    const float held = s.known.inside[index(curve)], say = s.say[index(curve)];
    const float* along = &s.curves.along[s.curves.at(curve, 0)];
    const float* costs = &s.costs[s.curves.at(curve, 0)];
    float* kept = &s.held[s.curves.at(curve, 0)];
    kept[0] = costs[0];
    for (int k = 1; k < s.curves.reached[index(curve)]; ++k) {
      const float change = quickLog(along[k] / held);
      const float beyond = (change < 0 ? -change : change) - most;
      kept[k] = say * costs[k] + price * (beyond > 0 ? beyond : 0.f);
    }
  });
  fillSide(s.held, true, s);
  fillSide(s.held, false, s);
  for (float& scale : s.problem.medialOffsetScale) scale *= kOppositeShare;
}

Status beginSearch(const Spine& spine, const PictureEvidence& picture, const RibParams& params, double farthest,
                   Search& s) {
  const image::EdgeMap& edges = picture.edges;
  if (!inRange(params)) return Error::ValueOutOfRange;
  if (spine.points.size() < 2) return Error::StrokeTooShort;
  s.spine = spine;
  s.edges = edges.empty() ? nullptr : &edges;
  s.params = params;
  s.farthest = farthest;
  s.field.assign(spine.points);
  if (!(s.field.length() > 0)) return Error::StrokeTooShort;
  chooseLevels(edges, picture.size, s);
  traceCurves(spine, s.field, s.levels, kFanCurves, picture.size, s.curves);
  return Done{};
}

bool usesColours(const PictureEvidence& picture, const RibParams& params) {
  return !picture.edges.empty() && params.evidence.knownShare > 0;
}

Status searchLabels(const Spine& spine, const PictureEvidence& picture, const RibParams& params,
                    const Progress& progress, Search& s) {
  if (!progress.advance(0.05)) return Error::Cancelled;
  const double anywhere = std::numeric_limits<double>::infinity();
  if (Status begun = beginSearch(spine, picture, params, anywhere, s); !begun.ok()) return begun;
  if (!progress.advance(0.4)) return Error::Cancelled;
  if (picture.edges.empty()) {
    defaultCosts(s);
  } else {
    unwrapImage(s.curves, picture.edges, picture.ignored, s.strip);
    findContours(s);
    firstEvidence(s);
  }
  fillProblem(s);
  fitWidthHypotheses(s);
  if (!progress.advance(0.5)) return Error::Cancelled;
  const bool withColours = usesColours(picture, params);
  bestLabels(withColours, s);
  if (withColours) tryOuterHypothesis(s);
  if (withColours && params.evidence.rimWeight > 0) {
    stiffLengths(s);
    thirdEvidence(s);
    findLabels(s.problem, std::numeric_limits<double>::infinity(), s.workspace, s.labels);
  }
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

RibWorkspace::Search& RibWorkspace::other() {
  if (!other_) other_ = std::make_unique<Search>();
  return *other_;
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
