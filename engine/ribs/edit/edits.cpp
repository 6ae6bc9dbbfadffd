#include "engine/ribs/edit/edits.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include "engine/ribs/edit/places.h"
#include "engine/ribs/edit/rib_frame.h"
#include "engine/ribs/field/d2.h"

namespace spineloft::ribs {
namespace {

// An added rib this close to another one (share of the gap it falls into) is that one.
constexpr double kSameRib = 0.01;
// An end that took more than this share of an edit counts as put there by hand.
constexpr double kEditedShare = 0.5;
// Shares below this move nothing: they are what rounding leaves at the rim of a reach.
constexpr double kLeastShare = 1e-9;
// How far ends that gather at a dragged one stay apart, as a share of the distance on the spine.
constexpr double kGatheredStep = 0.05;
// A fan grows at most by this factor when the rib of its end does.
constexpr double kMostFanGrowth = 8;

// One end of a rib, or a place between ribs where an edit acts and is measured.
struct Sample {
  double at = 0;
  PicturePoint end;
  int rib = -1;  // index of the rib; −1 between ribs
  bool moved = false, locked = false, byHand = false;
  bool pulled = false;  // an edit puts this very end somewhere
};

// Edits whose reach is less than the spacing of the ribs, at one place: the rib end nearest to it
// takes `rest` of them on top of the bell, so that what reaches it adds up to 1.
struct Narrow {
  double at = 0, reach = 0, rest = 0;
  int rib = -1;
};

PicturePoint& endOf(Rib& rib, Side side) { return side == Side::Left ? rib.left : rib.right; }

double shareOf(const EndEdit& edit, double at) {
  const double away = std::abs(at - edit.at);
  if (away <= kSamePlace) return 1;
  return edit.reach > 0 ? bell(away / edit.reach) : 0;
}

// Index of the place nearest to `at`; places ascend, ≥ 1.
std::size_t nearestPlace(const std::vector<double>& places, double at) {
  const auto above = std::ranges::lower_bound(places, at);
  if (above == places.begin()) return 0;
  const auto i = static_cast<std::size_t>(above - places.begin());
  if (i == places.size()) return i - 1;
  return at - places[i - 1] <= places[i] - at ? i - 1 : i;
}

// Distance between the two ribs on either side of `at` (the nearest two at an end), ≥ 2 places.
double gapAt(const std::vector<double>& places, double at) {
  const auto above = std::ranges::upper_bound(places, at);
  const auto i = std::clamp<std::ptrdiff_t>(above - places.begin(), 1, static_cast<std::ptrdiff_t>(places.size()) - 1);
  return places[static_cast<std::size_t>(i)] - places[static_cast<std::size_t>(i) - 1];
}

// The ends of one side under the edits of that side.
class SideEnds {
 public:
  SideEnds(const Ruler& ruler, std::vector<Rib>& ribs, const std::vector<double>& places, Side side)
      : ruler_(ruler), ribs_(ribs), places_(places), side_(side) {}

  // Returns whether any end changed.
  bool apply(const std::vector<EndEdit>& edits) {
    for (const EndEdit& edit : edits) {
      if (edit.side == side_ && usable(edit)) edits_.push_back(edit);
    }
    if (edits_.empty()) return false;
    sample();
    findNarrow();
    for (const EndEdit& edit : edits_) applyOne(edit);
    gather();
    return writeBack();
  }

 private:
  static bool usable(const EndEdit& e) {
    return e.at >= 0 && e.at <= 1 && e.reach >= 0 && std::abs(e.along) <= kFarthestEdit &&
           std::abs(e.out) <= kFarthestEdit;
  }

  // Where the line through the ends of this side passes `at`.
  PicturePoint between(double at) const {
    const auto above = std::ranges::lower_bound(places_, at);
    const auto i = static_cast<std::size_t>(above - places_.begin());
    if (i == 0 || i == places_.size()) {
      const std::size_t last = i == 0 ? 0 : i - 1;
      return endOf(ribs_[last], side_) + ruler_.pointAt(at) - ruler_.pointAt(places_[last]);
    }
    const double step = places_[i] - places_[i - 1];
    const double t = step > 0 ? (at - places_[i - 1]) / step : 0;
    return lerp(endOf(ribs_[i - 1], side_), endOf(ribs_[i], side_), t);
  }

  void sample() {
    for (std::size_t i = 0; i < ribs_.size(); ++i) {
      samples_.push_back({.at = places_[i], .end = endOf(ribs_[i], side_), .rib = static_cast<int>(i)});
    }
    for (const EndEdit& edit : edits_) {
      const double nearest = places_[nearestPlace(places_, edit.at)];
      if (std::abs(nearest - edit.at) > kSamePlace) {
        samples_.push_back({.at = edit.at, .end = between(edit.at)});
      }
    }
    std::ranges::stable_sort(samples_, {}, &Sample::at);
    const auto same = [](const Sample& a, const Sample& b) {
      return a.rib < 0 && b.rib < 0 && b.at - a.at <= kSamePlace;
    };
    samples_.erase(std::unique(samples_.begin(), samples_.end(), same), samples_.end());
  }

  void findNarrow() {
    for (const EndEdit& edit : edits_) {
      if (edit.reach >= gapAt(places_, edit.at)) continue;
      const auto rib = static_cast<int>(nearestPlace(places_, edit.at));
      narrow_.push_back({edit.at, edit.reach, 0, rib});
    }
    // Of several at one place the last counts.
    std::ranges::reverse(narrow_);
    std::ranges::stable_sort(narrow_, {}, &Narrow::at);
    const auto same = [](const Narrow& a, const Narrow& b) { return b.at - a.at <= kSamePlace; };
    narrow_.erase(std::unique(narrow_.begin(), narrow_.end(), same), narrow_.end());
    std::vector<double> taken(ribs_.size(), 0.0);
    std::vector<Narrow*> closest(ribs_.size(), nullptr);
    for (Narrow& n : narrow_) {
      const auto rib = static_cast<std::size_t>(n.rib);
      for (std::size_t i = rib > 0 ? rib - 1 : 0; i < std::min(rib + 2, ribs_.size()); ++i) {
        taken[i] += shareOf({.at = n.at, .reach = n.reach}, places_[i]);
      }
      const double away = std::abs(places_[rib] - n.at);
      if (!closest[rib] || away < std::abs(places_[rib] - closest[rib]->at)) closest[rib] = &n;
    }
    for (std::size_t i = 0; i < closest.size(); ++i) {
      if (closest[i]) closest[i]->rest = std::max(0.0, 1 - taken[i]);
    }
  }

  // What the nearest rib end takes of an edit beyond the bell.
  double restOf(const EndEdit& edit) const {
    if (edit.reach >= gapAt(places_, edit.at)) return 0;
    const auto at = std::ranges::lower_bound(narrow_, edit.at - kSamePlace, {}, &Narrow::at);
    return at != narrow_.end() && std::abs(at->at - edit.at) <= 2 * kSamePlace ? at->rest : 0;
  }

  void applyOne(const EndEdit& edit) {
    const int nearest = static_cast<int>(nearestPlace(places_, edit.at));
    const double gap = gapAt(places_, edit.at), rest = restOf(edit);
    const double reach = std::max(edit.reach, gap);
    const auto first = std::ranges::lower_bound(samples_, edit.at - reach - kSamePlace, {}, &Sample::at);
    const auto last = std::ranges::upper_bound(samples_, edit.at + reach + kSamePlace, {}, &Sample::at);
    const auto own = std::find_if(first, last, [&](const Sample& s) { return std::abs(s.at - edit.at) <= kSamePlace; });
    if (own == last) return;
    const PicturePoint by = ruler_.fromFrame(edit) - own->end;
    for (auto s = first; s != last; ++s) {
      double share = shareOf(edit, s->at);
      if (s->rib == nearest) share = std::min(1.0, share + rest);
      if (share < kLeastShare || s->locked) continue;
      s->end += by * share;
      s->moved = true;
      s->byHand = s->byHand || share > kEditedShare;
      s->pulled = s->pulled || s->rib == nearest;
    }
    for (auto s = first; edit.locked && s != last; ++s) {
      if (s == own || (s->rib == nearest && shareOf(edit, s->at) + rest > kEditedShare)) {
        s->locked = true;
      }
    }
  }

  // Ends that follow an edit gather at the dragged end when its rib would run across theirs: in
  // front of it when it was dragged ahead, behind it when back.
  void gather() {
    std::vector<Sample*> ends;
    for (Sample& s : samples_) {
      if (s.rib >= 0) ends.push_back(&s);
    }
    const auto n = static_cast<std::ptrdiff_t>(ends.size());
    for (std::ptrdiff_t h = 0; h < n; ++h) {
      if (!ends[static_cast<std::size_t>(h)]->pulled) continue;
      for (const std::ptrdiff_t step : {1, -1}) {
        for (std::ptrdiff_t k = h + step; k >= 0 && k < n; k += step) {
          Sample& s = *ends[static_cast<std::size_t>(k)];
          if (!s.moved || s.locked || s.pulled) break;
          makeWay(*ends[static_cast<std::size_t>(k - step)], s);
        }
      }
    }
  }

  void makeWay(const Sample& first, Sample& s) const {
    const PicturePoint a = ribs_[static_cast<std::size_t>(first.rib)].center;
    const PicturePoint b = ribs_[static_cast<std::size_t>(s.rib)].center;
    const PicturePoint u = first.end - a, v = s.end - b, w = b - a;
    const double turn = cross(u, v);
    if (turn == 0) return;
    const double onFirst = cross(w, v) / turn, onOther = cross(w, u) / turn;
    if (onFirst < 0 || onFirst > 1 || onOther < 0 || onOther > 1) return;
    s.end = first.end + w * kGatheredStep;
  }

  bool writeBack() {
    bool changed = false;
    for (const Sample& s : samples_) {
      if (s.rib < 0 || !(s.moved || s.locked)) continue;
      Rib& rib = ribs_[static_cast<std::size_t>(s.rib)];
      changed = true;
      endOf(rib, side_) = {std::clamp(s.end.x, rib.center.x - 2 * kFarthestEdit, rib.center.x + 2 * kFarthestEdit),
                           std::clamp(s.end.y, rib.center.y - 2 * kFarthestEdit, rib.center.y + 2 * kFarthestEdit)};
      if (!s.byHand && !s.locked) continue;
      const RibState state = s.locked ? RibState::Locked : RibState::Edited;
      (side_ == Side::Left ? rib.leftState : rib.rightState) = state;
      (side_ == Side::Left ? rib.leftConfidence : rib.rightConfidence) = 1;
    }
    return changed;
  }

  const Ruler& ruler_;
  std::vector<Rib>& ribs_;
  const std::vector<double>& places_;
  Side side_;
  std::vector<EndEdit> edits_;
  std::vector<Sample> samples_;  // ascending
  std::vector<Narrow> narrow_;   // ascending
};

// Ribs of one part while they are being added and left out, in order of their places.
struct Row {
  std::vector<Rib> ribs;
  std::vector<double> places;
};

void addRibs(const std::vector<double>& added, const Ruler& ruler, Row& row) {
  for (const double at : added) {
    if (!(at >= row.places.front() && at <= row.places.back())) continue;
    const auto above = std::ranges::lower_bound(row.places, at);
    const auto i = std::max<std::ptrdiff_t>(above - row.places.begin(), 1);
    const Rib a = row.ribs[static_cast<std::size_t>(i - 1)], b = row.ribs[static_cast<std::size_t>(i)];
    const double from = row.places[static_cast<std::size_t>(i - 1)];
    const double gap = row.places[static_cast<std::size_t>(i)] - from;
    const double t = gap > 0 ? (at - from) / gap : 0;
    if (t < kSameRib || t > 1 - kSameRib) continue;
    const auto mix = [t](double x, double y) { return x + (y - x) * t; };
    Rib rib;
    rib.center = ruler.pointAt(at);
    rib.left = lerp(a.left, b.left, t);
    rib.right = lerp(a.right, b.right, t);
    rib.leftState = rib.rightState = RibState::Bridged;
    rib.leftLevel = mix(a.leftLevel, b.leftLevel);
    rib.rightLevel = mix(a.rightLevel, b.rightLevel);
    row.ribs.insert(row.ribs.begin() + i, rib);
    row.places.insert(row.places.begin() + i, at);
  }
}

// Leaves out the ribs that stand at the given places, which are those of ribs.
void leaveOut(const std::vector<double>& gone, Row& row) {
  std::size_t to = 0, left = row.ribs.size();
  for (std::size_t i = 0; i < row.ribs.size(); ++i) {
    if (left > 2 && std::ranges::binary_search(gone, row.places[i])) {
      --left;
      continue;
    }
    row.ribs[to] = row.ribs[i];
    row.places[to++] = row.places[i];
  }
  row.ribs.resize(to);
  row.places.resize(to);
}

// The generated ribs with those added and without those left out. An added rib lies between
// generated ones whether these are left out or not.
Row chooseRibs(const Ruler& ruler, const Spine& spine, const RibSet& generated, const RibEdits& edits) {
  Row row{generated.ribs, ribPlaces(ruler, spine, generated)};
  if (!std::ranges::is_sorted(row.places)) return row;
  std::vector<double> gone;
  for (const double at : edits.removed) {
    if (at >= 0 && at <= 1) gone.push_back(row.places[nearestPlace(row.places, at)]);
  }
  std::ranges::sort(gone);
  addRibs(edits.added, ruler, row);
  leaveOut(gone, row);
  return row;
}

// The similarity that takes one rib's ends to another's; where the first has no width, the shift
// of their middles.
void moveFan(EndFan& fan, const Rib& from, const Rib& to) {
  if (from.left == to.left && from.right == to.right) return;
  using Complex = std::complex<double>;
  const auto complex = [](PicturePoint p) { return Complex{p.x, p.y}; };
  const Complex middle = complex((from.left + from.right) / 2);
  const Complex newMiddle = complex((to.left + to.right) / 2);
  const Complex across = complex(from.right - from.left), newAcross = complex(to.right - to.left);
  Complex turn{1, 0};
  if (std::abs(across) > 1e-9) turn = newAcross / across;
  if (std::abs(turn) > kMostFanGrowth) turn *= kMostFanGrowth / std::abs(turn);
  for (PicturePoint& p : fan.points) {
    const Complex q = newMiddle + (complex(p) - middle) * turn;
    p = {q.real(), q.imag()};
  }
}

// The fan of the rib that a search found at an end and that edits made `to` of.
void placeFan(EndFan& fan, const std::vector<RibPoint>& put, bool atStart, const Rib& from, const Rib& to) {
  if (put.empty())
    moveFan(fan, from, to);
  else
    fan.points = RibFrame(to.left, to.right, atStart).toPicture(put);
}

// d2 of the ends that moved. `was` holds the ribs as they were, the same number.
void measureLevels(const Spine& spine, const std::vector<Rib>& was, std::vector<Rib>& ribs) {
  const D2Field field(spine.points);
  for (std::size_t i = 0; i < ribs.size(); ++i) {
    if (!(ribs[i].left == was[i].left)) ribs[i].leftLevel = field.distance(ribs[i].left);
    if (!(ribs[i].right == was[i].right)) ribs[i].rightLevel = field.distance(ribs[i].right);
  }
}

}  // namespace

bool isValid(const RibEdits& edits) {
  const auto share = [](double value) { return value >= 0 && value <= 1; };
  const auto near = [](RibPoint p) { return std::abs(p.x) <= kFarthestFan && std::abs(p.y) <= kFarthestFan; };
  const auto isFan = [&](const std::vector<RibPoint>& fan) {
    return fan.size() <= kMostFanPoints && std::ranges::all_of(fan, near);
  };
  return isFan(edits.startFan) && isFan(edits.endFan) && edits.ends.size() <= kMostEndEdits &&
         edits.added.size() <= kMostAddedRibs && edits.removed.size() <= kMostAddedRibs &&
         std::ranges::all_of(edits.added, share) && std::ranges::all_of(edits.removed, share) &&
         std::ranges::all_of(edits.ends, [&](const EndEdit& end) {
           return share(end.at) && share(end.reach) && std::abs(end.along) <= kFarthestEdit &&
                  std::abs(end.out) <= kFarthestEdit && end.side <= Side::Right;
         });
}

RibSet applyEdits(const Spine& spine, const RibSet& generated, const RibEdits& edits) {
  if (edits.empty() || generated.ribs.size() < 2 || spine.points.size() < 2) return generated;
  const Ruler ruler(spine.points);
  if (!(ruler.length() > 0)) return generated;
  Row row = chooseRibs(ruler, spine, generated, edits);
  const std::vector<Rib> before = row.ribs;
  bool changed = SideEnds(ruler, row.ribs, row.places, Side::Left).apply(edits.ends);
  changed = SideEnds(ruler, row.ribs, row.places, Side::Right).apply(edits.ends) || changed;
  if (changed) measureLevels(spine, before, row.ribs);
  RibSet set = generated;
  set.ribs = std::move(row.ribs);
  placeFan(set.startFan, edits.startFan, true, generated.ribs.front(), set.ribs.front());
  placeFan(set.endFan, edits.endFan, false, generated.ribs.back(), set.ribs.back());
  return set;
}

}  // namespace spineloft::ribs
