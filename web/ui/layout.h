// Where everything lies on the canvas, from its size alone.
#pragma once

#include <span>

#include "web/ui/space.h"

namespace spineloft::app {

/// Below it the views are stacked and the panel is a strip below them, unless the canvas is low: a
/// phone on its side, a large page zoom.
inline constexpr double kStackedWidth = 700;
inline constexpr double kLowShape = 0.62;  ///< height over width under which a canvas is low
/// From it on the panel stands at the right side; between the two it is a strip below the views.
inline constexpr double kPanelWidthFrom = 1000;
inline constexpr double kPanelWidth = 272, kLowPanelWidth = 240;  ///< at the side; of a phone on its side
inline constexpr double kStripHeight = 152;                       ///< with two rows of tiles
inline constexpr double kFlatStripHeight = 130;                   ///< with one, where the width allows
inline constexpr double kFlatStripFrom = 600;
inline constexpr double kSplitter = 8;        ///< width of the bar between the views
inline constexpr double kPicturesStrip = 60;  ///< what the strip of pictures takes
inline constexpr double kMinShare = 0.22, kMaxShare = 0.78;

struct Layout {
  Rect picture, solid, splitter, panel;
  Rect pictures;         ///< the strip of pictures, where there are several; else empty
  bool stacked = false;  ///< picture above solid
  bool strip = false;    ///< the panel is a strip with tabs
  bool operator==(const Layout&) const = default;
};

/// `share` of the views' space that goes to the picture, clamped to kMinShare…kMaxShare. `hasPanel`
/// is false on an empty board: then the views have all the room.
Layout layoutFor(double width, double height, double share, bool hasPanel);

/// Takes the room for the strip of pictures from the picture view: a row above it, or a column at its
/// left side where the view is low.
void reservePictures(Layout& layout);

/// While a section is drawn: `picture` is the room of its board, the solid stays in sight beside it, or
/// above it on a tall canvas. No splitter; the panel only where it stands at the side.
Layout layoutWithBoard(double width, double height);

enum class Toward { Head, Foot };
/// Words above a view, moved towards its head or foot just as far as they have to be so that at least `gap` is between
/// them and everything in `taken`. They may end up outside of the view: then there is no room for them.
Rect clearOf(Rect words, std::span<const Rect> taken, double gap, Toward way);

/// What is left of a view beside everything in `taken`, as one rectangle: of each the side that costs least is given
/// up. What covers all of the view does not count: it is a menu, and goes.
Rect roomBeside(Rect view, std::span<const Rect> taken);

/// The share for which the splitter's middle would lie under `at`.
double shareAt(const Layout& layout, ClientPoint at);

}  // namespace spineloft::app
