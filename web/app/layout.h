// Where everything lies on the canvas, from its size alone.
#pragma once

#include "web/app/space.h"

namespace spineloft::app {

/// Below it the views are stacked and the panel is a strip below them.
inline constexpr double kStackedWidth = 700;
/// From it on the panel stands at the right side; between the two it is a strip below the views.
inline constexpr double kPanelWidthFrom = 1000;
inline constexpr double kPanelWidth = 240;
inline constexpr double kStripHeight = 152;
inline constexpr double kSplitter = 8;  ///< width of the bar between the views
inline constexpr double kMinShare = 0.22, kMaxShare = 0.78;

struct Layout {
  Rect picture, solid, splitter, panel;
  bool stacked = false;  ///< picture above solid
  bool strip = false;    ///< the panel is a strip with tabs
  bool operator==(const Layout&) const = default;
};

/// `share` of the views' space that goes to the picture, clamped to kMinShare…kMaxShare. `hasPanel`
/// is false on an empty board: then the views have all the room.
Layout layoutFor(double width, double height, double share, bool hasPanel);

/// The share for which the splitter's middle would lie under `at`.
double shareAt(const Layout& layout, ClientPoint at);

}  // namespace spineloft::app
