// What tools preview and commands do about regions: the same functions.
#pragma once

#include <optional>
#include <vector>

#include "engine/document/document.h"
#include "web/app/ui_state.h"

namespace spineloft::app {

/// The points of a region that a hand can drag: a few along each outline, at its corners and between.
std::vector<OutlinePoint> outlineHandles(const document::Region& region);
PicturePoint pointOf(const document::Region& region, OutlinePoint at);
/// The handle within `reach` picture pixels; none elsewhere.
std::optional<OutlinePoint> handleAt(const document::Region& region, PicturePoint p, double reach);

/// The region with a point of it moved; its neighbours follow, less the farther they are, to half way to
/// the next handle and beyond. Unchanged when there is no such point.
document::Region withMovedPoint(const document::Region& region, OutlinePoint at, PicturePoint to);

}  // namespace spineloft::app
