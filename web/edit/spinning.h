// The axis about which the tool Spin turns what is drawn beside it.
#pragma once

#include <optional>
#include <vector>

#include "engine/document/document.h"
#include "web/ui/ui_state.h"

namespace spineloft::app {

/// The axis that is shown in the picture in view: that of the selected part while it is a spun one, else that of the
/// next part.
struct ShownAxis {
  PartId part;            ///< none: of the next part
  PicturePoint from, to;  ///< picture pixels
};
/// None without the tool, or without a picture.
std::optional<ShownAxis> shownAxis(const document::Document& document, const UiState& ui);

/// The axis whose ends a hand can take: that of a part in hand which is not being drawn again. Lines begin at an axis,
/// often at its end, so that without a part to change every press draws.
std::optional<ShownAxis> axisInHand(const document::Document& document, const UiState& ui);
/// The end of it within `reach` picture pixels, 0 or 1; −1 elsewhere.
int axisEndAt(const ShownAxis& axis, PicturePoint p, double reach);
/// The axis moved aside, as far as it takes to go through a point.
ShownAxis axisThrough(const ShownAxis& axis, PicturePoint p);
/// The axis with an end put elsewhere. It becomes upright, or level, where it is within 2 degrees of that, and keeps a
/// length.
ShownAxis withMovedEnd(const ShownAxis& axis, int end, PicturePoint to);

/// How the next part is turned: as the panels say, about the axis that is shown.
lathe::LatheParams nextLathe(const document::Document& document, const UiState& ui);
/// The profile that a line stands for: closed where its ends are near each other, else open, with fewer points.
document::Region profileOfLine(PictureId picture, const std::vector<PicturePoint>& line, image::Size size);

}  // namespace spineloft::app
