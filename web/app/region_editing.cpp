#include "web/app/region_editing.h"

#include <algorithm>
#include <cmath>

namespace spineloft::app {
namespace {

constexpr std::size_t kHandles = 14;  // of one outline

double lengthOf(const std::vector<PicturePoint>& contour) {
  double length = 0;
  for (std::size_t i = 1; i < contour.size(); ++i) length += distance(contour[i - 1], contour[i]);
  return length;
}

}  // namespace

std::vector<OutlinePoint> outlineHandles(const document::Region& region) {
  std::vector<OutlinePoint> handles;
  for (std::size_t c = 0; c < region.contours.size(); ++c) {
    const auto& contour = region.contours[c];
    if (contour.empty()) continue;
    if (contour.size() <= kHandles) {
      for (std::size_t i = 0; i < contour.size(); ++i) handles.push_back({c, i});
      continue;
    }
    const bool open = region.ribbon > 0;
    const double step = lengthOf(contour) / static_cast<double>(open ? kHandles - 1 : kHandles);
    double walked = 0, next = 0;
    for (std::size_t i = 0; i < contour.size(); ++i) {
      if (i > 0) walked += distance(contour[i - 1], contour[i]);
      if (walked + 1e-9 < next && !(open && i + 1 == contour.size())) continue;
      handles.push_back({c, i});
      next += step;
    }
    // The end of a closed line is its beginning.
    const bool twice = !open && handles.size() > 3 && handles.back().contour == c &&
                       distance(contour[handles.back().point], contour.front()) < step / 2;
    if (twice) handles.pop_back();
  }
  return handles;
}

PicturePoint pointOf(const document::Region& region, OutlinePoint at) {
  if (at.contour >= region.contours.size() || at.point >= region.contours[at.contour].size()) return {};
  return region.contours[at.contour][at.point];
}

std::optional<OutlinePoint> handleAt(const document::Region& region, PicturePoint p, double reach) {
  std::optional<OutlinePoint> found;
  double nearest = reach;
  for (const OutlinePoint handle : outlineHandles(region)) {
    const double away = distance(p, pointOf(region, handle));
    if (away > nearest) continue;
    nearest = away;
    found = handle;
  }
  return found;
}

document::Region withMovedPoint(const document::Region& region, OutlinePoint at, PicturePoint to) {
  document::Region moved = region;
  if (at.contour >= region.contours.size()) return moved;
  const auto& contour = region.contours[at.contour];
  if (at.point >= contour.size()) return moved;
  auto& out = moved.contours[at.contour];
  const PicturePoint by = to - contour[at.point];
  if (contour.size() <= kHandles) {
    out[at.point] = to;
    return moved;
  }
  const double reach = 1.5 * lengthOf(contour) / static_cast<double>(kHandles);
  const std::size_t n = contour.size();
  const bool open = region.ribbon > 0;
  const auto pull = [&](std::size_t i, double away) {
    const double t = away / reach;
    out[i] = contour[i] + by * (t < 1 ? 0.5 + 0.5 * std::cos(3.14159265358979323846 * t) : 0);
  };
  out[at.point] = to;
  double forth = 0, back = 0;
  for (std::size_t k = 1; k < n; ++k) {
    const std::size_t i = (at.point + k) % n, before = (at.point + k - 1) % n;
    if (open && i == 0) break;
    forth += distance(contour[before], contour[i]);
    if (forth >= reach) break;
    pull(i, forth);
  }
  for (std::size_t k = 1; k < n; ++k) {
    const std::size_t i = (at.point + n - k) % n, after = (at.point + n - k + 1) % n;
    if (open && after == 0) break;
    back += distance(contour[after], contour[i]);
    if (back >= reach) break;
    pull(i, back);
  }
  return moved;
}

}  // namespace spineloft::app
