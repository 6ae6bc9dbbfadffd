#include "web/edit/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/geometry/polygon.h"
#include "engine/geometry/polyline.h"
#include "engine/loft/straight_end.h"

namespace spineloft::app {
namespace {

bool nearSpine(const pipeline::PartShape& shape, PicturePoint p, double reach) {
  const auto& line = shape.centreLine;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const PicturePoint a{line[i - 1].x, -line[i - 1].y}, b{line[i].x, -line[i].y};
    if (geometry::distanceToSegment(p, a, b) <= reach) return true;
  }
  return false;
}

/// By even-odd: not in a hole.
bool holdsRegion(const std::vector<std::vector<PicturePoint>>& contours, PicturePoint p) {
  bool in = false;
  for (const auto& contour : contours) {
    if (geometry::holds(std::span<const PicturePoint>(contour), p)) in = !in;
  }
  return in;
}

}  // namespace

void outlineOf(const ribs::RibSet& set, const loft::LoftParams& params, std::vector<PicturePoint>& out) {
  out.clear();
  std::vector<loft::Chord> chords;
  chords.reserve(set.ribs.size());
  for (const ribs::Rib& rib : set.ribs) chords.push_back({rib.left, rib.right});
  loft::cutStraightEnds(chords, set, params);
  for (const loft::Chord& chord : chords) out.push_back(chord.left);
  if (params.endCap == sections::CapStyle::Round) {
    const auto& fan = set.endFan.points;
    out.insert(out.end(), fan.begin(), fan.end());
  }
  for (auto chord = chords.rbegin(); chord != chords.rend(); ++chord) out.push_back(chord->right);
  if (params.startCap == sections::CapStyle::Round) {
    const auto& fan = set.startFan.points;
    out.insert(out.end(), fan.rbegin(), fan.rend());
  }
}

PartId partAt(const document::Document& document, const pipeline::Derived& derived, PictureId picture, PicturePoint p,
              double reach) {
  std::vector<PicturePoint> outline;
  const std::size_t count = std::min(document.parts.size(), derived.parts.size());
  const document::Part* found = nullptr;
  for (std::size_t i = count; i-- > 0;) {
    const document::Part& part = document.parts[i];
    const auto& shape = derived.parts[i].shape;
    if (!shape || !pipeline::isVisible(document, part) || document::pictureOf(part) != picture) continue;
    if (found != nullptr && part.placement.move.z <= found->placement.move.z) continue;
    if (holdsRegion(shape->contours, p)) {
      found = &part;
      continue;
    }
    if (document::loftOf(part) == nullptr) continue;
    outlineOf(shape->shown, document::loftIn(part).loft, outline);
    if (geometry::holds(std::span<const PicturePoint>(outline), p) || nearSpine(*shape, p, reach)) found = &part;
  }
  return found ? found->id : PartId{};
}

}  // namespace spineloft::app
