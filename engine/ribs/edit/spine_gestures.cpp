#include "engine/ribs/edit/spine_gestures.h"

#include <algorithm>
#include <cmath>

#include "engine/geometry/polyline.h"
#include "engine/ribs/edit/places.h"

namespace spineloft::ribs {
namespace {

using Points = std::vector<PicturePoint>;

// A bent stroke has at least this many points.
constexpr std::size_t kBendPoints = 128;
// Points on which a bend spreads at least to either side, so that it is no needle.
constexpr double kLeastBend = 2;
// A cut leaves at least this share of the stroke.
constexpr double kLeastLeft = 0.02;

bool isUsable(std::span<const PicturePoint> stroke) {
  return stroke.size() >= 2 && std::ranges::all_of(stroke, [](PicturePoint p) { return isFinite(p); });
}

}  // namespace

Points bendStroke(std::span<const PicturePoint> stroke, double at, PicturePoint to, double reach) {
  Points out(stroke.begin(), stroke.end());
  if (!isUsable(stroke) || !isFinite(to) || !(at >= 0 && at <= 1) || !(reach >= 0)) return out;
  const std::size_t count = std::max(stroke.size(), kBendPoints);
  const Ruler ruler(stroke);
  if (!(ruler.length() > 0)) return out;
  out = geometry::resample(stroke, count);
  const double step = 1 / static_cast<double>(count - 1);
  // The point nearest to the place stands exactly on it, so that it goes exactly to `to`.
  const auto own = static_cast<std::size_t>(std::lround(at / step));
  const PicturePoint by = to - ruler.pointAt(at);
  const double spread = std::max(reach, kLeastBend * step);
  for (std::size_t i = 0; i < count; ++i) {
    const double here = i == own ? at : static_cast<double>(i) * step;
    if (i == own) out[i] = ruler.pointAt(at);
    const double share = bell((here - at) / spread);
    if (share > 0) out[i] += by * share;
  }
  return out;
}

Points shiftStroke(std::span<const PicturePoint> stroke, PicturePoint by) {
  Points out(stroke.begin(), stroke.end());
  if (!isFinite(by)) return out;
  for (PicturePoint& p : out) p += by;
  return out;
}

Points extendStroke(std::span<const PicturePoint> stroke, bool atStart, PicturePoint to) {
  Points out(stroke.begin(), stroke.end());
  if (!isUsable(stroke) || !isFinite(to)) return out;
  if (atStart) std::ranges::reverse(out);
  {
    const Points line = out;
    const Ruler ruler(line);
    const double nearest = ruler.placeOf(to);
    const bool ahead = nearest >= 1 || dot(to - line.back(), ruler.tangentAt(1)) >= 0;
    if (ahead) {
      if (!(to == line.back())) out.push_back(to);
    } else {
      const double cut = std::max(nearest, kLeastLeft);
      std::size_t keep = 1;
      while (keep + 1 < line.size() && ruler.placeOfPoint(keep) < cut) ++keep;
      out.resize(keep);
      out.push_back(ruler.pointAt(cut));
    }
  }
  if (atStart) std::ranges::reverse(out);
  return out;
}

}  // namespace spineloft::ribs
