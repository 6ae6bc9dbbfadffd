// Lines on the picture: solid, dashed, dotted, with a halo.
#pragma once

#include <imgui.h>

#include <span>

#include "engine/base/vec.h"
#include "web/ui/ui_state.h"

namespace spineloft::panels {

enum class LineStyle { Solid, Dashed, Dotted };

struct Pen {
  ImU32 colour = 0;
  float width = 1;
  LineStyle style = LineStyle::Solid;
};

/// Colour and line style of a rib whose end is that sure of its place.
Pen ribPen(ribs::RibState state);

/// A straight line in CSS pixels.
void styledLine(ImDrawList& list, ImVec2 a, ImVec2 b, const Pen& pen);

/// A polyline of picture points as the picture view shows it.
void picturePolyline(ImDrawList& list, const app::UiState& ui, std::span<const PicturePoint> points, const Pen& pen,
                     bool closed = false);

ImVec2 onCanvas(const app::UiState& ui, PicturePoint p);

}  // namespace spineloft::panels
