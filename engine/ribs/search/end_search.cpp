#include "engine/ribs/search/end_search.h"

#include <algorithm>

namespace spineloft::ribs {
namespace {

// Of so many ribs at most one may belong to an end, on either side.
constexpr int kRibsPerFree = 3;
// An end whose last ribs reach less than this share of a half width beyond the stroke bends round nothing.
constexpr double kBent = 0.25;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// One end of a set of ribs, counted inwards.
struct End {
  bool atStart;
  RibSet& set;
  Search& s;

  int ribAt(int inwards) const { return atStart ? inwards : s.problem.ribs - 1 - inwards; }
  Rib& rib(int inwards) const { return set.ribs[index(ribAt(inwards))]; }

  // How far a point lies beyond the stroke.
  double beyond(PicturePoint p) const {
    const CurveLayout& layout = s.curves.layout;
    const int middle = atStart ? layout.startFan(layout.fan / 2) : layout.endFan(layout.fan / 2);
    const auto& seed = s.curves.seeds[index(middle)];
    return dot(p - seed[0], normalized(seed[1] - seed[0]));
  }

  int reachingBeyond(PicturePoint Rib::* side) const {
    int count = 0;
    while (count < s.problem.ribs / kRibsPerFree && beyond(rib(count).*side) > 0) ++count;
    return count;
  }

  EndSite site(int freeLeft, int freeRight, double halfWidth) const {
    return {.curves = s.curves,
            .costs = s.costs,
            .atStart = atStart,
            .freeLeft = freeLeft,
            .freeRight = freeRight,
            .left = rib(freeLeft).left,
            .right = rib(freeRight).right,
            .leftLabel = s.labels.left[index(ribAt(freeLeft))],
            .rightLabel = s.labels.right[index(ribAt(freeRight))],
            .halfWidth = halfWidth,
            .neighbourWeight = s.problem.neighbourWeight};
  }

  // The costs of the ends of the outermost ribs.
  double costOf(int count, bool leftSide) const {
    const std::vector<int>& labels = leftSide ? s.labels.left : s.labels.right;
    double cost = 0;
    for (int i = 0; i < count; ++i) {
      const int at = ribAt(i), curve = s.curves.layout.sideOf(at, leftSide);
      cost += static_cast<double>(s.costs[s.curves.at(curve, labels[index(at)])]);
    }
    return cost;
  }

  double farthest(int count, PicturePoint Rib::* side) const {
    double far = 0;
    for (int i = 0; i < count; ++i) far = std::max(far, beyond(rib(i).*side));
    return far;
  }
  double farthest(const EndOutline& outline) const {
    double far = 0;
    for (const PicturePoint& p : outline.points) far = std::max(far, beyond(p));
    return far;
  }

  // Moves an end of the rib to the outline's `at`-th point.
  void move(int inwards, bool leftSide, const EndOutline& outline, int at) const {
    const int label = outline.labels[index(at)];
    const int curve = s.curves.layout.sideOf(ribAt(inwards), leftSide);
    Rib& moved = rib(inwards);
    (leftSide ? moved.left : moved.right) = outline.points[index(at)];
    (leftSide ? moved.leftLevel : moved.rightLevel) = s.levels.d2[index(label)];
    (leftSide ? moved.leftState : moved.rightState) =
        s.boundary.isOnEdge(s.curves.at(curve, label)) ? RibState::Edge : RibState::Guessed;
  }
};

}  // namespace

void findEnd(bool atStart, RibSet& set, Search& s) {
  EndFan& fan = atStart ? set.startFan : set.endFan;
  const End end{atStart, set, s};
  const int left = end.reachingBeyond(&Rib::left), right = end.reachingBeyond(&Rib::right);
  const double half = std::max(1.0, distance(end.rib(left).left, end.rib(right).right) / 2);
  EndOutline &held = s.ends[0], &freed = s.ends[1];
  const EndSite last = end.site(0, 0, half);
  followEnd(last, s.workspace, held);
  if (std::max(end.beyond(last.left), end.beyond(last.right)) < kBent * half) {
    fanOf(last, held, fan);
    return;
  }
  const EndSite before = end.site(left, right, half);
  followEnd(before, s.workspace, freed);
  const double cost = held.cost + end.costOf(left, true) + end.costOf(right, false);
  const double far = std::max({end.farthest(held), end.farthest(left, &Rib::left), end.farthest(right, &Rib::right)});
  if (freed.cost > cost || end.farthest(freed) > far) {
    fanOf(last, held, fan);
    return;
  }
  for (int i = 0; i < left; ++i) end.move(left - 1 - i, true, freed, i);
  for (int i = 0; i < right; ++i) end.move(i, false, freed, left + s.curves.layout.fan + i);
  fanOf(before, freed, fan);
}

}  // namespace spineloft::ribs
