#include "engine/ribs/edit/edit_gestures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/geometry/polyline.h"
#include "engine/ribs/edit/places.h"

namespace spineloft::ribs {
namespace {

// A new rib closer to another one than this share of the gap goes to the middle of a gap instead.
constexpr double kTooClose = 0.1;
// A rib that was left out comes back when one is added this close to it, as a share of the gap.
constexpr double kSameGap = 0.25;
// How much farther from or nearer to the spine a line of other places may get from one rib to the
// next: as a share of the distance between the ribs, and of that to the place left behind.
constexpr double kLineSlope = 1.0, kLineJump = 0.35;

// Edits this close to a rib's place (share of the gap beside it) are edits of this rib: a stroke
// that was changed shifts places a little.
constexpr double kSameEnd = 0.02;

double tolerance(double reach) { return kSameEnd * reach; }

PicturePoint endOf(const Rib& rib, Side side) { return side == Side::Left ? rib.left : rib.right; }
RibState stateOf(const Rib& rib, Side side) { return side == Side::Left ? rib.leftState : rib.rightState; }
const OtherPlaces& othersOf(const Rib& rib, Side side) { return side == Side::Left ? rib.leftOthers : rib.rightOthers; }

// A scene with the places of its ribs.
class Bench {
 public:
  explicit Bench(const EditScene& scene)
      : scene_(scene), ruler_(scene.spine.points), places_(ribPlaces(ruler_, scene.spine, scene.ribs)) {}

  const Ruler& ruler() const { return ruler_; }
  double place(std::size_t rib) const { return places_[rib]; }
  // Distances to the ribs before and after; at an end both are that to the only neighbour.
  double gapBefore(std::size_t rib) const {
    return rib > 0 ? places_[rib] - places_[rib - 1] : places_[1] - places_[0];
  }
  double gapAfter(std::size_t rib) const {
    return rib + 1 < places_.size() ? places_[rib + 1] - places_[rib] : gapBefore(rib);
  }
  // The reach of an edit that moves one rib alone.
  double alone(std::size_t rib) const { return std::max(0.0, std::min(gapBefore(rib), gapAfter(rib))); }
  // Whether an edit belongs to this rib rather than to those beside it.
  bool owns(std::size_t rib, double at) const {
    const double away = at - places_[rib];
    return away < 0 ? -away <= gapBefore(rib) / 2 + kSamePlace : away <= gapAfter(rib) / 2 + kSamePlace;
  }
  EndEdit editOf(EndRef end, PicturePoint to, double reach) const {
    EndEdit edit{.at = places_[end.rib], .side = end.side, .reach = std::min(reach, 1.0)};
    ruler_.toFrame(to, edit);
    edit.along = std::clamp(edit.along, -kFarthestEdit, kFarthestEdit);
    edit.out = std::clamp(edit.out, -kFarthestEdit, kFarthestEdit);
    return edit;
  }
  // Appends an edit; one that it makes pointless goes.
  void put(RibEdits& edits, const EndEdit& edit, std::size_t rib) const {
    const double gap = alone(rib);
    const bool isAlone = edit.reach <= gap + tolerance(gap);
    for (auto e = edits.ends.rbegin(); e != edits.ends.rend(); ++e) {
      if (e->side != edit.side) continue;
      const double away = std::abs(e->at - edit.at);
      if (away <= kSamePlace + tolerance(gap) && !e->locked &&
          std::abs(e->reach - edit.reach) <= tolerance(edit.reach)) {
        edits.ends.erase(std::next(e).base());
        break;
      }
      // What the later edit measured, the earlier one must not change.
      if (away < (isAlone ? gap - tolerance(gap) : edit.reach + e->reach)) break;
    }
    edits.ends.push_back(edit);
  }
  // Moves one end alone, locked or not.
  void moveAlone(RibEdits& edits, EndRef end, PicturePoint to) const {
    EndEdit edit = editOf(end, to, alone(end.rib));
    if (stateOf(scene_.ribs.ribs[end.rib], end.side) == RibState::Locked) {
      edit.locked = true;
      for (EndEdit& e : edits.ends) {
        if (!e.locked || e.side != end.side || !owns(end.rib, e.at)) continue;
        e = edit;
        return;
      }
    }
    put(edits, edit, end.rib);
  }

 private:
  const EditScene& scene_;
  Ruler ruler_;
  std::vector<double> places_;
};

bool isUsable(const EditScene& scene) { return scene.ribs.ribs.size() >= 2 && scene.spine.points.size() >= 2; }
bool has(const EditScene& scene, std::size_t rib) { return isUsable(scene) && rib < scene.ribs.ribs.size(); }
// The edits, unless they have become too many.
RibEdits accept(RibEdits edits, const EditScene& scene) { return isValid(edits) ? std::move(edits) : scene.edits; }

// Where a stroke crosses the line of a rib end, as a distance from the rib's centre: the crossing
// nearest to the end, within `within` of it.
std::optional<double> crossing(PicturePoint centre, PicturePoint out, double length,
                               std::span<const PicturePoint> stroke, double within) {
  std::optional<double> best;
  for (std::size_t i = 0; i + 1 < stroke.size(); ++i) {
    const PicturePoint u = stroke[i + 1] - stroke[i], from = stroke[i] - centre;
    const double turn = cross(out, u);
    if (turn == 0) continue;
    const double t = cross(from, u) / turn, along = cross(from, out) / turn;
    if (!(along >= 0 && along <= 1 && t >= 0 && std::abs(t - length) <= within)) continue;
    if (!best || std::abs(t - length) < std::abs(*best - length)) best = t;
  }
  return best;
}

struct RibLine {
  PicturePoint centre, out;
  double length;
};
RibLine lineOf(const Bench& bench, const Rib& rib, std::size_t index, Side side) {
  const PicturePoint reach = endOf(rib, side) - rib.center;
  const double length = norm(reach);
  return {rib.center, length > 1e-9 ? reach / length : bench.ruler().outAt(bench.place(index), side), length};
}

}  // namespace

std::optional<EndRef> nearestEnd(const RibSet& ribs, PicturePoint p, double within) {
  std::optional<EndRef> best;
  double nearest = within;
  for (std::size_t i = 0; i < ribs.ribs.size(); ++i) {
    for (const Side side : {Side::Left, Side::Right}) {
      const double away = distance(p, endOf(ribs.ribs[i], side));
      if (!(best ? away < nearest : away <= nearest)) continue;
      nearest = away;
      best = EndRef{i, side};
    }
  }
  return best;
}

std::optional<std::size_t> nearestRib(const RibSet& ribs, PicturePoint p, double within) {
  std::optional<std::size_t> best;
  double nearest = within;
  for (std::size_t i = 0; i < ribs.ribs.size(); ++i) {
    const Rib& rib = ribs.ribs[i];
    const double away = std::min(geometry::distanceToSegment(p, rib.left, rib.center),
                                 geometry::distanceToSegment(p, rib.center, rib.right));
    if (!(best ? away < nearest : away <= nearest)) continue;
    nearest = away;
    best = i;
  }
  return best;
}

double placeOf(const Spine& spine, PicturePoint p) {
  if (spine.points.empty() || !isFinite(p)) return 0;
  return Ruler(spine.points).placeOf(p);
}

double placeOf(const EditScene& scene, std::size_t rib) { return has(scene, rib) ? Bench(scene).place(rib) : 0; }

RibEdits dragEnd(const EditScene& scene, EndRef end, PicturePoint to, double reach) {
  RibEdits edits = scene.edits;
  if (!has(scene, end.rib) || !isFinite(to)) return edits;
  const Bench bench(scene);
  const bool locked = stateOf(scene.ribs.ribs[end.rib], end.side) == RibState::Locked;
  if (locked || !(reach > bench.alone(end.rib))) {
    bench.moveAlone(edits, end, to);
  } else {
    bench.put(edits, bench.editOf(end, to, reach), end.rib);
  }
  return accept(std::move(edits), scene);
}

StrokeDeform deformByStroke(const EditScene& scene, std::span<const PicturePoint> stroke, double within,
                            bool bothSides) {
  StrokeDeform deform{{}, scene.edits};
  if (!isUsable(scene) || !std::ranges::all_of(stroke, [](PicturePoint p) { return isFinite(p); })) return deform;
  const Bench bench(scene);
  for (std::size_t i = 0; i < scene.ribs.ribs.size(); ++i) {
    const Rib& rib = scene.ribs.ribs[i];
    std::array<RibLine, 2> lines{lineOf(bench, rib, i, Side::Left), lineOf(bench, rib, i, Side::Right)};
    std::array<std::optional<double>, 2> to, own;
    for (std::size_t s = 0; s < 2; ++s) {
      own[s] = crossing(rib.center, lines[s].out, lines[s].length, stroke, within);
    }
    for (std::size_t s = 0; s < 2; ++s) {
      const std::size_t other = 1 - s;
      to[s] = own[s];
      if (!to[s] && bothSides && own[other] && lines[other].length > 1e-9) {
        to[s] = lines[s].length * *own[other] / lines[other].length;
      }
      const Side side = s == 0 ? Side::Left : Side::Right;
      if (!to[s] || stateOf(rib, side) == RibState::Locked) continue;
      deform.touched.push_back({i, side});
      bench.moveAlone(deform.edits, {i, side}, rib.center + lines[s].out * *to[s]);
    }
  }
  if (!isValid(deform.edits)) return {{}, scene.edits};
  return deform;
}

RibEdits lockRib(const EditScene& scene, std::size_t rib, bool locked) {
  RibEdits edits = scene.edits;
  if (!has(scene, rib)) return edits;
  const Bench bench(scene);
  for (const Side side : {Side::Left, Side::Right}) {
    const Rib& seen = scene.ribs.ribs[rib];
    if ((stateOf(seen, side) == RibState::Locked) == locked) continue;
    if (locked) {
      EndEdit edit = bench.editOf({rib, side}, endOf(seen, side), bench.alone(rib));
      edit.locked = true;
      bench.put(edits, edit, rib);
      continue;
    }
    // Freed at the end of the list: edits that came after the lock must not move it now.
    std::erase_if(edits.ends, [&](const EndEdit& e) { return e.locked && e.side == side && bench.owns(rib, e.at); });
    bench.put(edits, bench.editOf({rib, side}, endOf(seen, side), bench.alone(rib)), rib);
  }
  return accept(std::move(edits), scene);
}

RibEdits addRib(const EditScene& scene, PicturePoint p) {
  RibEdits edits = scene.edits;
  if (!isUsable(scene) || !isFinite(p)) return edits;
  const Bench bench(scene);
  double at = bench.ruler().placeOf(p);
  std::size_t next = 1;
  while (next + 1 < scene.ribs.ribs.size() && bench.place(next) <= at) ++next;
  double gap = bench.place(next) - bench.place(next - 1);
  const std::size_t near = at - bench.place(next - 1) < gap / 2 ? next - 1 : next;
  if (std::abs(at - bench.place(near)) < kTooClose * gap || at < bench.place(next - 1) || at > bench.place(next)) {
    const bool last = near + 1 == scene.ribs.ribs.size();
    const bool ahead = !last && (near == 0 || bench.gapAfter(near) >= bench.gapBefore(near));
    gap = ahead ? bench.gapAfter(near) : bench.gapBefore(near);
    at = bench.place(near) + (ahead ? gap : -gap) / 2;
  }
  const auto back =
      std::ranges::find_if(edits.removed, [&](double left) { return std::abs(left - at) <= kSameGap * gap; });
  if (back != edits.removed.end()) {
    edits.removed.erase(back);
  } else {
    edits.added.push_back(at);
  }
  return accept(std::move(edits), scene);
}

RibEdits removeRib(const EditScene& scene, std::size_t rib) {
  RibEdits edits = scene.edits;
  if (!has(scene, rib) || scene.ribs.ribs.size() <= 2) return edits;
  const Bench bench(scene);
  const double at = bench.place(rib), alone = bench.alone(rib);
  const auto own = [&](double place) { return std::abs(place - at) <= 1e3 * kSamePlace; };
  if (std::erase_if(edits.added, own) == 0) edits.removed.push_back(at);
  std::erase_if(edits.ends,
                [&](const EndEdit& e) { return own(e.at) && (e.locked || e.reach <= alone + tolerance(alone)); });
  return accept(std::move(edits), scene);
}

RibEdits resetRib(const EditScene& scene, std::size_t rib) {
  RibEdits edits = scene.edits;
  if (!has(scene, rib)) return edits;
  const Bench bench(scene);
  std::erase_if(edits.ends, [&](const EndEdit& e) { return bench.owns(rib, e.at); });
  return edits;
}

RibEdits takeOtherPlace(const EditScene& scene, EndRef end, int other, bool likeNeighbours) {
  RibEdits edits = scene.edits;
  if (!has(scene, end.rib)) return edits;
  const std::vector<Rib>& ribs = scene.ribs.ribs;
  const OtherPlaces& first = othersOf(ribs[end.rib], end.side);
  if (other < 0 || other >= first.count) return edits;
  const Bench bench(scene);
  const auto place = first.at[static_cast<std::size_t>(other)];
  bench.moveAlone(edits, end, place);
  for (const int step : {-1, 1}) {
    if (!likeNeighbours) break;
    std::size_t before = end.rib;
    PicturePoint line = place;
    for (;;) {
      if (step < 0 ? before == 0 : before + 1 >= ribs.size()) break;
      const std::size_t i = step < 0 ? before - 1 : before + 1;
      const PicturePoint home = endOf(ribs[i], end.side);
      // The same distance from the spine as the rib before.
      const double wanted = distance(ribs[before].center, line);
      const auto offLine = [&](PicturePoint p) { return std::abs(distance(ribs[i].center, p) - wanted); };
      const OtherPlaces& others = othersOf(ribs[i], end.side);
      PicturePoint best = home;
      for (int k = 0; k < others.count; ++k) {
        const PicturePoint candidate = others.at[static_cast<std::size_t>(k)];
        if (offLine(candidate) < offLine(best)) best = candidate;
      }
      const double spacing = distance(ribs[before].center, ribs[i].center);
      const bool onLine =
          offLine(best) <= std::max(kLineSlope * spacing, 1.0) && offLine(best) <= kLineJump * distance(best, home);
      if (best == home || !onLine || stateOf(ribs[i], end.side) == RibState::Locked) break;
      bench.moveAlone(edits, {i, end.side}, best);
      line = best;
      before = i;
    }
  }
  return accept(std::move(edits), scene);
}

}  // namespace spineloft::ribs
