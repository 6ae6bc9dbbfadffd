#include "engine/ribs/search/live_trace.h"

#include <algorithm>
#include <cmath>

#include "engine/ribs/search/rib_search.h"

namespace spineloft::ribs {
namespace {

// Shares of the labels for a move, and for the repetition of passes 1 and 2.
constexpr double kMoveLabels = 7. / 16, kRefineLabels = 3. / 4;
constexpr int kFewestLabels = 16;
// How far out a move searches: a multiple of the farthest end, and map pixels more. The colours around an object are
// learned up to there.
constexpr double kFarOut = 2, kFarOutMargin = 16;
// Passes 1 and 2 are repeated when the stroke has grown by kGrown, or its line has moved by kMoved of the width.
// Beyond the second numbers it counts as another stroke.
constexpr double kGrown = 1.05, kGrownMuch = 1.6, kMoved = 0.04, kMovedMuch = 0.25;
// Places along the stroke at which that is looked at.
constexpr int kPlaces = 16;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

RibParams withShare(const RibParams& params, double share) {
  RibParams fewer = params;
  fewer.levels = std::max(std::min(params.levels, kFewestLabels), static_cast<int>(share * params.levels));
  return fewer;
}

// Between which entries of an even table over `length` an arc length lies, and how far; held to the end.
struct Place {
  std::size_t first;
  float share;
};
Place placeIn(std::size_t size, double length, double arc) {
  const double at = std::clamp(arc / length, 0.0, 1.0) * static_cast<double>(size - 1);
  const auto first = std::min(static_cast<std::size_t>(at), size - 2);
  return {first, static_cast<float>(at - static_cast<double>(first))};
}

float valueAt(const std::vector<float>& table, const Place& place) {
  const float from = table[place.first];
  return from + place.share * (table[place.first + 1] - from);
}

PicturePoint pointAt(const Spine& spine, const Place& place) {
  return lerp(spine.points[place.first], spine.points[place.first + 1], static_cast<double>(place.share));
}

// Spines are evenly spaced.
double lengthOf(const Spine& spine) {
  return distance(spine.points[0], spine.points[1]) * static_cast<double>(spine.points.size() - 1);
}

// How far the beginning of a stroke has moved since, at most, as a share of the width there.
double movedBy(const Learned& learned, const Spine& spine, double length) {
  double most = 0;
  for (int i = 0; i <= kPlaces; ++i) {
    const double arc = learned.studied * i / kPlaces;
    const Place there = placeIn(learned.left.size(), learned.length, arc);
    const double width =
        static_cast<double>(valueAt(learned.left, there)) + static_cast<double>(valueAt(learned.right, there));
    const PicturePoint before = pointAt(learned.spine, placeIn(learned.spine.points.size(), learned.studied, arc));
    const PicturePoint now = pointAt(spine, placeIn(spine.points.size(), length, arc));
    most = std::max(most, distance(before, now) / std::max(1.0, width));
  }
  return most;
}

void learn(const Search& s, Learned& learned) {
  const WidthHypothesis& even = s.parts.all[s.contest.chosen];
  learned.spine.points = s.spine.points;
  learned.length = learned.studied = lengthOf(s.spine);
  learned.lean = even.lean;
  learned.width = even.width;
  for (auto* table : {&learned.left, &learned.right, &learned.leftWeight, &learned.rightWeight}) table->clear();
  for (int i = 0; i < s.curves.layout.ribs; ++i) {
    const std::size_t left = index(s.curves.layout.left(i)), right = index(s.curves.layout.right(i));
    learned.left.push_back(s.known.inside[left]);
    learned.right.push_back(s.known.inside[right]);
    learned.leftWeight.push_back(s.say[left]);
    learned.rightWeight.push_back(s.say[right]);
  }
}

// What is known of the stroke as it is now; what has come to it since is taken to be like its end.
void recall(const Learned& learned, WidthHypothesis& even, Search& s) {
  const int ribs = s.curves.layout.ribs;
  const double length = lengthOf(s.spine);
  even.lean = learned.lean;
  even.width.resize(index(ribs));
  s.known.inside.assign(index(s.curves.layout.total()), 0.f);
  s.say.assign(s.known.inside.size(), 1.f);
  for (int i = 0; i < ribs; ++i) {
    const Place place = placeIn(learned.left.size(), learned.length, length * i / (ribs - 1));
    const std::size_t left = index(s.curves.layout.left(i)), right = index(s.curves.layout.right(i));
    even.width[index(i)] = valueAt(learned.width, place);
    s.known.inside[left] = valueAt(learned.left, place);
    s.known.inside[right] = valueAt(learned.right, place);
    s.say[left] = valueAt(learned.leftWeight, place);
    s.say[right] = valueAt(learned.rightWeight, place);
  }
}

// Adds what a move found beyond what was studied.
void extend(const Search& s, Learned& longer, Learned& learned) {
  const int ribs = s.curves.layout.ribs;
  const double length = lengthOf(s.spine);
  for (auto* table : {&longer.width, &longer.left, &longer.right, &longer.leftWeight, &longer.rightWeight})
    table->clear();
  for (int i = 0; i < ribs; ++i) {
    const double arc = length * i / (ribs - 1);
    const Place place = placeIn(learned.left.size(), learned.length, arc);
    const std::size_t l = index(s.curves.layout.left(i)), r = index(s.curves.layout.right(i));
    const float left = s.known.inside[l], right = s.known.inside[r];
    const bool beyond = arc > learned.studied;
    longer.left.push_back(beyond ? left : valueAt(learned.left, place));
    longer.right.push_back(beyond ? right : valueAt(learned.right, place));
    longer.width.push_back(beyond ? left + right : valueAt(learned.width, place));
    longer.leftWeight.push_back(beyond ? s.say[l] : valueAt(learned.leftWeight, place));
    longer.rightWeight.push_back(beyond ? s.say[r] : valueAt(learned.rightWeight, place));
  }
  learned.left.swap(longer.left);
  learned.right.swap(longer.right);
  learned.width.swap(longer.width);
  learned.leftWeight.swap(longer.leftWeight);
  learned.rightWeight.swap(longer.rightWeight);
  learned.length = length;
}

}  // namespace

bool LiveTrace::follows(const Spine& spine, const PictureEvidence& picture, const RibParams& params) const {
  if (learned_.empty() || spine.points.size() < kShort) return false;
  if (edges_ != &picture.edges || ignored_ != picture.ignored) return false;
  if (size_ != picture.size || params_ != params) return false;
  const double length = lengthOf(spine);
  return length < kGrownMuch * learned_.studied && kGrownMuch * length > learned_.studied &&
         movedBy(learned_, spine, length) < kMovedMuch;
}

bool LiveTrace::changed(const Spine& spine) const {
  const double length = lengthOf(spine);
  return length > kGrown * learned_.studied || kGrown * length < learned_.studied ||
         movedBy(learned_, spine, length) > kMoved;
}

Status LiveTrace::follow(const Spine& spine, const PictureEvidence& picture, const RibParams& params, RibSet& set) {
  Search& s = now_.search();
  const double farthest =
      static_cast<double>(std::max(std::ranges::max(learned_.left), std::ranges::max(learned_.right)));
  const double margin = kFarOutMargin * std::max(picture.edges.scaleX, picture.edges.scaleY);
  Status begun = beginSearch(spine, picture, withShare(params, kMoveLabels), kFarOut * farthest + margin, s);
  if (!begun.ok()) return begun;
  unwrapImage(s.curves, picture.edges, picture.ignored, s.strip);
  findContours(s);
  recall(learned_, s.parts.all[0], s);
  s.costs.assign(s.curves.x.size(), 0.f);
  fillProblem(s);
  assumeWidth(s.parts.all[0], s);
  thirdEvidence(s);
  findLabels(s.problem, std::numeric_limits<double>::infinity(), s.workspace, s.labels);
  readRibs(false, s, set);
  stiffLengths(s);
  extend(s, longer_, learned_);
  return Done{};
}

// Passes 1 and 2, in steps of about equal cost.
Status LiveTrace::study(const Spine& spine, const PictureEvidence& picture, const RibParams& params) {
  enum { kIdle, kCurves, kStrip, kContours, kEvidence, kParts, kFirstPart };
  Search& s = looks_.search();
  if (step_ == kIdle && !changed(spine)) return Done{};
  switch (++step_) {
    case kCurves:
      return beginSearch(spine, picture, withShare(params, kRefineLabels), std::numeric_limits<double>::infinity(), s);
    case kStrip:
      unwrapImage(s.curves, picture.edges, picture.ignored, s.strip);
      return Done{};
    case kContours:
      findContours(s);
      return Done{};
    case kEvidence:
      firstEvidence(s);
      fillProblem(s);
      return Done{};
    case kParts:
      fitWidthHypotheses(s);
      s.contest = {};
      return Done{};
    default:
      break;
  }
  const int part = step_ - kFirstPart;
  tryHypothesis(index(part), true, s);
  if (index(part + 1) < s.parts.count) return Done{};
  stiffLengths(s);
  learn(s, learned_);
  step_ = kIdle;
  return Done{};
}

Result<LiveTrace::Ribs> LiveTrace::move(const Spine& spine, const PictureEvidence& picture, const RibParams& params) {
  Ribs found;
  const Result<bool> exact = move(spine, picture, params, found.set);
  if (!exact) return exact.failure();
  found.exact = exact.value();
  return found;
}

Result<bool> LiveTrace::move(const Spine& spine, const PictureEvidence& picture, const RibParams& params, RibSet& set) {
  if (follows(spine, picture, params)) {
    if (Status followed = follow(spine, picture, params, set); !followed.ok()) return followed.failure();
    if (Status studied = study(spine, picture, params); !studied.ok()) return studied.failure();
    return false;
  }
  Search& s = now_.search();
  step_ = 0;
  learned_.spine.points.clear();
  const Status searched = searchRibs(spine, picture, params, unwatched_, s, set);
  if (!searched.ok()) return searched.failure();
  if (usesColours(picture, params) && params.evidence.rimWeight > 0) {
    learn(s, learned_);
    params_ = params;
    size_ = picture.size;
    edges_ = &picture.edges;
    ignored_ = picture.ignored;
  }
  return true;
}

}  // namespace spineloft::ribs
