#include "web/panels/draw_lines.h"

#include <algorithm>
#include <cmath>

#include "engine/geometry/polyline.h"
#include "web/panels/theme.h"

namespace spineloft::panels {
namespace {

constexpr double kUnseen = 0.2;  // CSS pixels that a line may be off

}  // namespace

ImVec2 onCanvas(const app::UiState& ui, PicturePoint p) {
  const app::ClientPoint at = ui.pictureView.toClient(p, ui.layout.picture);
  return {static_cast<float>(at.x), static_cast<float>(at.y)};
}

Pen ribPen(ribs::RibState state) {
  switch (state) {
    case ribs::RibState::Edge:
      return {kEdgeRib, 1.4f, LineStyle::Solid};
    case ribs::RibState::Bridged:
      return {kBridgedRib, 1.5f, LineStyle::Dashed};
    case ribs::RibState::Guessed:
      return {kGuessedRib, 1.6f, LineStyle::Dotted};
    case ribs::RibState::Edited:
      return {kEditedRib, 1.9f, LineStyle::Solid};
    case ribs::RibState::Locked:
      return {kInk, 2.2f, LineStyle::Solid};
  }
  return {};
}

void styledLine(ImDrawList& list, ImVec2 a, ImVec2 b, const Pen& pen) {
  const float dx = b.x - a.x, dy = b.y - a.y;
  const float length = std::sqrt(dx * dx + dy * dy);
  if (pen.style == LineStyle::Solid || length < 3) {
    list.AddLine(a, b, pen.colour, pen.width);
    return;
  }
  const bool dotted = pen.style == LineStyle::Dotted;
  const float on = dotted ? 1.5f : 5.f, step = dotted ? 4.5f : 9.f;
  const float ux = dx / length, uy = dy / length;
  for (float s = 0; s < length; s += step) {
    const float e = std::min(s + on, length);
    list.AddLine({a.x + ux * s, a.y + uy * s}, {a.x + ux * e, a.y + uy * e}, pen.colour, pen.width);
  }
}

void picturePolyline(ImDrawList& list, const app::UiState& ui, std::span<const PicturePoint> points, const Pen& pen,
                     bool closed) {
  if (points.size() < 2) return;
  if (pen.style != LineStyle::Solid) {
    for (std::size_t i = 1; i < points.size(); ++i) {
      styledLine(list, onCanvas(ui, points[i - 1]), onCanvas(ui, points[i]), pen);
    }
    return;
  }
  list.PathClear();
  for (const std::size_t i : geometry::keptPoints(points, kUnseen / ui.pictureView.zoom)) {
    list.PathLineTo(onCanvas(ui, points[i]));
  }
  list.PathStroke(pen.colour, closed ? ImDrawFlags_Closed : ImDrawFlags_None, pen.width);
}

}  // namespace spineloft::panels
