// What tools preview and commands do about regions: the same functions.
#pragma once

#include <optional>
#include <vector>

#include "engine/document/document.h"
#include "web/ui/ui_state.h"

namespace spineloft::app {

/// Takes the points of a part in hand, as a tap on it does; of what has no outline there are none.
void takePoints(UiState& ui, const document::Part& part);
/// The part made of a region whose points are shown and dragged: nobody draws anything else just now; null: none.
const document::Part* partWithPoints(const document::Document& document, const UiState& ui);

/// The points of a region that a hand can drag: a few along each outline, at its corners and between.
std::vector<OutlinePoint> outlineHandles(const document::Region& region);
PicturePoint pointOf(const document::Region& region, OutlinePoint at);
/// The handle within `reach` picture pixels; none elsewhere.
std::optional<OutlinePoint> handleAt(const document::Region& region, PicturePoint p, double reach);

/// The region with a point of it moved; its neighbours follow, less the farther they are, to half way to
/// the next handle and beyond. Unchanged when there is no such point.
document::Region withMovedPoint(const document::Region& region, OutlinePoint at, PicturePoint to);

/// The handle after this point along its outline, or the one before; on from the last outline to the
/// first. The first handle of all when there is no such point; none without handles.
std::optional<OutlinePoint> neighbourHandle(const document::Region& region, const std::optional<OutlinePoint>& from,
                                            int by);

/// One more point to move, half way to the next handle: outlines of few points get it, of others it is
/// a point that they have. Returns the region and the point; none when there is no such point.
struct AddedPoint {
  document::Region region;
  OutlinePoint at;
};
std::optional<AddedPoint> withAddedPoint(const document::Region& region, OutlinePoint after);

/// Without the point: the outline goes straight from the handle before to the one after. None when too
/// few points would be left, or there is no such point.
std::optional<document::Region> withoutPoint(const document::Region& region, OutlinePoint at);

}  // namespace spineloft::app
