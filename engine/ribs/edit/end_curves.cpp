#include "engine/ribs/edit/end_curves.h"

#include <algorithm>
#include <cmath>

namespace spineloft::ribs {
namespace {

/// Points of a curve, evenly apart: all machines space them alike.
constexpr int kPoints = 256;
/// A curve is followed as long as it gains this share of its length outwards.
constexpr double kLeastGain = 0.25;

double outOf(PicturePoint p) { return p.y; }

/// Where `value` is among ascending values, ≥ 2: before the first and behind the last as well.
struct Spot {
  std::size_t before = 0;
  double share = 0;  ///< of the way to the next one
  template <class Value, class Of>
  Spot(const std::vector<Value>& ascending, double value, Of of) {
    const auto next =
        std::partition_point(ascending.begin() + 1, ascending.end() - 1, [&](const Value& v) { return of(v) < value; });
    before = static_cast<std::size_t>(next - ascending.begin()) - 1;
    share = (value - of(*(next - 1))) / (of(*next) - of(*(next - 1)));
  }
};

}  // namespace

EndCurves::EndCurves(const Spine& spine, image::Size picture) {
  const D2Field field(spine.points);
  const double farthest = std::max(picture.width, picture.height);
  GradientCurves curves;
  traceCurves(spine, field, makeLevels(kPoints, farthest, farthest, field.length()), 0, picture, curves);
  const Ruler ruler(spine.points);
  for (const Side side : {Side::Left, Side::Right}) {
    for (std::size_t rib = 0; rib < spine.points.size(); ++rib) lines_.push_back(lineAt(ruler, curves, rib, side));
  }
}

EndCurves::Line EndCurves::lineAt(const Ruler& ruler, const GradientCurves& curves, std::size_t rib, Side side) {
  const int curve = curves.layout.sideOf(static_cast<int>(rib), side == Side::Left);
  Line line{{PicturePoint{}}, {0}};
  EndEdit end{.at = ruler.placeOfPoint(rib), .side = side};
  for (int k = 1; k < curves.reached[static_cast<std::size_t>(curve)]; ++k) {
    ruler.toFrame(curves.point(curve, k), end);
    const PicturePoint next{end.along, end.out}, step = next - line.points.back();
    if (!(step.y > kLeastGain * norm(step))) break;
    line.points.push_back(next);
    line.lengths.push_back(line.lengths.back() + norm(step));
  }
  if (line.points.size() < 2) return {{{0, 0}, {0, 1}}, {0, 1}};
  return line;
}

const EndCurves::Line& EndCurves::lineOf(std::size_t rib, Side side) const {
  return lines_[side == Side::Left ? rib : lines_.size() / 2 + rib];
}

EndOnCurve EndCurves::tell(std::size_t rib, const EndEdit& end, double step) const {
  const Line& line = lineOf(rib, end.side);
  const Spot at(line.points, end.out, outOf);
  const double length = std::lerp(line.lengths[at.before], line.lengths[at.before + 1], at.share);
  EndOnCurve told{0, std::round(length / step) * step};
  EndEdit on{.side = end.side};
  put(rib, told, on);
  told.beside = end.along - on.along;
  return told;
}

void EndCurves::put(std::size_t rib, const EndOnCurve& told, EndEdit& end) const {
  const Line& line = lineOf(rib, end.side);
  const Spot at(line.lengths, told.length, [](double length) { return length; });
  const PicturePoint on = lerp(line.points[at.before], line.points[at.before + 1], at.share);
  end.along = on.x + told.beside;
  end.out = on.y;
}

}  // namespace spineloft::ribs
