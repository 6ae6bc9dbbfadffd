#include "web/edit/region_editing.h"

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

void takePoints(UiState& ui, const document::Part& part) {
  ui.pointsOf = part.id;
  ui.pointsKnown = ui.pointsKnown || document::regionOf(part.recipe) != nullptr;
}

const document::Part* partWithPoints(const document::Document& document, const UiState& ui) {
  if (!drawsRegions(ui.tool) || ui.cut || ui.redraw || !ui.pointsOf || ui.pointsOf != ui.selection) return nullptr;
  const document::Part* part = document::findPart(document, ui.pointsOf);
  const document::Region* region = part ? document::regionOf(part->recipe) : nullptr;
  return region != nullptr && region->picture == ui.picture ? part : nullptr;
}

std::vector<OutlinePoint> outlineHandles(const document::Region& region) {
  std::vector<OutlinePoint> handles;
  for (std::size_t c = 0; c < region.contours.size(); ++c) {
    const auto& contour = region.contours[c];
    if (contour.empty()) continue;
    if (contour.size() <= kHandles) {
      for (std::size_t i = 0; i < contour.size(); ++i) handles.push_back({c, i});
      continue;
    }
    const bool open = region.isOfLines();
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
  const bool open = region.isOfLines();
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

std::optional<OutlinePoint> neighbourHandle(const document::Region& region, const std::optional<OutlinePoint>& from,
                                            int by) {
  const std::vector<OutlinePoint> handles = outlineHandles(region);
  if (handles.empty()) return std::nullopt;
  if (!from) return by > 0 ? handles.front() : handles.back();
  const auto isBefore = [](OutlinePoint a, OutlinePoint b) {
    return a.contour != b.contour ? a.contour < b.contour : a.point < b.point;
  };
  if (by > 0) {
    const auto next = std::ranges::upper_bound(handles, *from, isBefore);
    return next == handles.end() ? handles.front() : *next;
  }
  const auto at = std::ranges::lower_bound(handles, *from, isBefore);
  return at == handles.begin() ? handles.back() : *(at - 1);
}

namespace {

/// The handles of the same outline round a point, as indices; equal to it where an open line ends.
struct Between {
  std::size_t before = 0, after = 0;
};
Between between(const document::Region& region, OutlinePoint at) {
  std::vector<std::size_t> own;
  for (const OutlinePoint handle : outlineHandles(region)) {
    if (handle.contour == at.contour && handle.point != at.point) own.push_back(handle.point);
  }
  if (own.empty()) return {at.point, at.point};
  const auto next = std::ranges::upper_bound(own, at.point);
  const bool open = region.isOfLines();
  const std::size_t after = next != own.end() ? *next : open ? at.point : own.front();
  const std::size_t before = next != own.begin() ? *(next - 1) : open ? at.point : own.back();
  return {before, after};
}

bool isThere(const document::Region& region, OutlinePoint at) {
  return at.contour < region.contours.size() && at.point < region.contours[at.contour].size();
}

}  // namespace

std::optional<AddedPoint> withAddedPoint(const document::Region& region, OutlinePoint after) {
  if (!isThere(region, after)) return std::nullopt;
  AddedPoint added{region, after};
  auto& contour = added.region.contours[after.contour];
  const std::size_t n = contour.size();
  const Between round = between(region, after);
  if (n > kHandles) {
    const std::size_t end = round.after > after.point ? round.after : round.after + n;
    added.at.point = round.after == after.point ? after.point : (after.point + (end - after.point) / 2) % n;
    return added;
  }
  // At the end of an open line it comes before the last point.
  const bool last = round.after == after.point;
  if (last && after.point == 0) return std::nullopt;
  const std::size_t from = last ? after.point - 1 : after.point;
  const PicturePoint middle = (contour[from] + contour[(from + 1) % n]) / 2;
  contour.insert(contour.begin() + static_cast<std::ptrdiff_t>(from) + 1, middle);
  added.at.point = from + 1;
  return added;
}

std::optional<document::Region> withoutPoint(const document::Region& region, OutlinePoint at) {
  if (!isThere(region, at)) return std::nullopt;
  document::Region left = region;
  auto& contour = left.contours[at.contour];
  const std::size_t n = contour.size();
  const auto [before, after] = n > kHandles ? between(region, at) : Between{at.point, at.point};
  const bool first = before == at.point, last = after == at.point;
  const auto goes = [&](std::size_t i) {
    if (i == at.point) return true;
    if (first && last) return false;
    if (first) return i < after;
    if (last) return i > before;
    return before < after ? i > before && i < after : i > before || i < after;
  };
  std::vector<PicturePoint> kept;
  for (std::size_t i = 0; i < n; ++i) {
    if (!goes(i)) kept.push_back(contour[i]);
  }
  if (kept.size() < (region.isOfLines() ? 2u : 3u)) return std::nullopt;
  contour = std::move(kept);
  return left;
}

}  // namespace spineloft::app
