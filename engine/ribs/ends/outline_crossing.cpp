#include "engine/ribs/ends/outline_crossing.h"

#include <algorithm>
#include <array>

namespace spineloft::ribs {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

struct Edge {
  PicturePoint a, b;
};

bool within(const std::vector<PicturePoint>& outline, PicturePoint p) {
  int winding = 0;
  PicturePoint a = outline.back();
  for (const PicturePoint& b : outline) {
    if (a.y <= p.y && b.y > p.y && cross(b - a, p - a) > 0) ++winding;
    if (a.y > p.y && b.y <= p.y && cross(b - a, p - a) < 0) --winding;
    a = b;
  }
  return winding != 0;
}

// One curve and the place at which it leaves what was looked at so far.
class Leaving {
 public:
  Leaving(const GradientCurves& curves, int curve)
      : curves_(curves), curve_(curve), last_(curves.reached[index(curve)] - 1), at_(along(last_)) {
    for (int k = 0; k <= last_; ++k) {
      const PicturePoint p = curves.point(curve, k);
      least_ = {std::min(least_.x, p.x), std::min(least_.y, p.y)};
      most_ = {std::max(most_.x, p.x), std::max(most_.y, p.y)};
    }
  }

  void meet(const Edge& edge) {
    if (misses(edge)) return;
    double before = sideOf(edge, 0);
    for (int k = 0; k < last_; ++k) {
      const double behind = sideOf(edge, k + 1);
      if ((before > 0) != (behind > 0) && passesBetween(edge, k)) {
        const double here = along(k) + before / (before - behind) * (along(k + 1) - along(k));
        at_ = std::min(at_, here);
        last_ = k + 1;  // what is farther out counts no more
        return;
      }
      before = behind;
    }
  }

  float at() const { return static_cast<float>(at_); }

 private:
  double along(int k) const { return static_cast<double>(curves_.along[curves_.at(curve_, k)]); }
  double sideOf(const Edge& edge, int k) const { return cross(edge.b - edge.a, curves_.point(curve_, k) - edge.a); }
  bool passesBetween(const Edge& edge, int k) const {
    const PicturePoint p = curves_.point(curve_, k), step = curves_.point(curve_, k + 1) - p;
    return (cross(step, edge.a - p) > 0) != (cross(step, edge.b - p) > 0);
  }
  bool misses(const Edge& edge) const {
    const auto [a, b] = edge;
    return std::max(a.x, b.x) < least_.x || std::min(a.x, b.x) > most_.x || std::max(a.y, b.y) < least_.y ||
           std::min(a.y, b.y) > most_.y;
  }

  const GradientCurves& curves_;
  int curve_, last_;
  double at_;
  PicturePoint least_ = curves_.point(curve_, 0), most_ = least_;
};

}  // namespace

std::vector<PicturePoint> outlineOf(const RibSet& part) {
  std::vector<PicturePoint> outline;
  for (const Rib& rib : part.ribs) outline.push_back(rib.left);
  outline.insert(outline.end(), part.endFan.points.begin(), part.endFan.points.end());
  for (auto rib = part.ribs.rbegin(); rib != part.ribs.rend(); ++rib) outline.push_back(rib->right);
  outline.insert(outline.end(), part.startFan.points.rbegin(), part.startFan.points.rend());
  return outline;
}

std::vector<float> lengthsWithin(const std::vector<PicturePoint>& outline, const GradientCurves& curves) {
  std::vector<float> lengths(index(curves.layout.total()), 0.f);
  if (outline.size() < 3) return lengths;
  for (int c = 0; c < curves.layout.total(); ++c) {
    if (!within(outline, curves.point(c, 0))) continue;
    Leaving leaving(curves, c);
    PicturePoint a = outline.back();
    for (const PicturePoint& b : outline) {
      leaving.meet({a, b});
      a = b;
    }
    lengths[index(c)] = leaving.at();
  }
  return lengths;
}

std::vector<float> withoutSpikes(const std::vector<float>& lengths, const CurveLayout& layout) {
  constexpr int kReach = 2;
  const int total = layout.total();
  std::vector<float> calm = lengths;
  std::array<float, 2 * kReach + 1> near{};
  for (const int first : {layout.endFan(0), layout.startFan(layout.fan - 1)}) {
    for (int c = first; c < first + layout.fan; ++c) {
      for (int k = -kReach; k <= kReach; ++k) near[index(k + kReach)] = lengths[index((c + k + total) % total)];
      std::ranges::nth_element(near, near.begin() + kReach);
      calm[index(c)] = near[kReach];
    }
  }
  return calm;
}

}  // namespace spineloft::ribs
