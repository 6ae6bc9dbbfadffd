// The points of a graph in a panel: where they can go, and new ones.
#pragma once

#include <cstddef>
#include <utility>

#include "engine/geometry/along.h"
#include "web/ui/section_ui.h"

namespace spineloft::app {

/// The ends of a way from one section to the next stay where they are; every other point can go.
bool isFixedPoint(GraphArea::Kind kind, const geometry::AlongCurve& curve, std::size_t point);
inline constexpr double kLeastGraphGap = 0.01;  ///< share of the graph's width between two points
/// From where to where it can go between its neighbours; the second is smaller where there is no room.
std::pair<double, double> roomOfPoint(const geometry::AlongCurve& curve, std::size_t point);
/// With one more point, or that which is nearly there: `point` receives its number. A curve without points gets its
/// ends first, at `rest`.
geometry::AlongCurve withPointAt(geometry::AlongCurve curve, geometry::AlongPoint added, double rest,
                                 std::size_t& point);
/// In the middle of the widest room between two points.
double widestGap(const geometry::AlongCurve& curve);

}  // namespace spineloft::app
