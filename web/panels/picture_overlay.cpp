// What is drawn over the picture: outlines of all parts, bone and ribs of the selected one, the
// stroke under the pen.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "web/app/outline.h"
#include "web/app/preview.h"
#include "web/panels/draw_lines.h"
#include "web/panels/panels.h"
#include "web/panels/theme.h"

namespace spineloft::panels {
namespace {

constexpr double kRibSpacing = 5;  // CSS pixels: nearer ribs are left out of the drawing

Pen ribPen(ribs::RibState state) {
  switch (state) {
    case ribs::RibState::Edge:
      return {kEdgeRib, 1.4f, LineStyle::Solid};
    case ribs::RibState::Bridged:
      return {kBridgedRib, 1.5f, LineStyle::Dashed};
    case ribs::RibState::Guessed:
      return {kGuessedRib, 1.6f, LineStyle::Dotted};
    case ribs::RibState::Edited:
    case ribs::RibState::Locked:
      return {kInk, 1.6f, LineStyle::Solid};
  }
  return {};
}

void ribEnd(ImDrawList& list, ImVec2 at, ribs::RibState state) {
  const Pen pen = ribPen(state);
  if (state == ribs::RibState::Edge) {
    list.AddCircleFilled(at, 2.6f, kSurface, 10);
    list.AddCircleFilled(at, 1.9f, pen.colour, 10);
  } else {
    list.AddCircleFilled(at, 2.6f, kSurface, 10);
    list.AddCircle(at, 2.2f, pen.colour, 10, 1.1f);
  }
}

void drawRibs(ImDrawList& list, const app::UiState& ui, const ribs::RibSet& set) {
  if (set.ribs.size() < 2) return;
  const double spacing = distance(set.ribs[0].center, set.ribs[1].center) * ui.pictureView.zoom;
  const auto step = static_cast<std::size_t>(
      std::clamp(std::ceil(kRibSpacing / std::max(spacing, 1e-3)), 1.0, 64.0));
  for (int pass = 0; pass < 2; ++pass) {
    for (std::size_t i = 0; i < set.ribs.size(); i += step) {
      const ribs::Rib& rib = set.ribs[i];
      const ImVec2 centre = onCanvas(ui, rib.center);
      const ImVec2 left = onCanvas(ui, rib.left), right = onCanvas(ui, rib.right);
      if (pass == 0) {
        styledLine(list, centre, left, ribPen(rib.leftState));
        styledLine(list, centre, right, ribPen(rib.rightState));
      } else {
        ribEnd(list, left, rib.leftState);
        ribEnd(list, right, rib.rightState);
      }
    }
  }
}

void drawSpine(ImDrawList& list, const app::UiState& ui, std::span<const PicturePoint> points) {
  if (points.empty()) return;
  picturePolyline(list, ui, points, {rgb(0xffffff, 235), 6.5f, LineStyle::Solid});
  picturePolyline(list, ui, points, {kSpine, 3.2f, LineStyle::Solid});
  for (const PicturePoint end : {points.front(), points.back()}) {
    list.AddCircleFilled(onCanvas(ui, end), 5.f, kSurface, 20);
    list.AddCircleFilled(onCanvas(ui, end), 3.6f, kSpine, 20);
  }
}

void drawOutline(ImDrawList& list, const PanelEnv& env, const document::Part& part,
                 const pipeline::PartShape& shape) {
  static std::vector<PicturePoint> outline;  // reused from frame to frame
  app::outlineOf(shape, part.recipe.loft, outline);
  const bool selected = part.id == env.ui().selection;
  const float halo = selected ? 4.5f : 3.f, width = selected ? 2.2f : 1.4f;
  picturePolyline(list, env.ui(), outline, {rgb(0xffffff, selected ? 200 : 120), halo}, true);
  picturePolyline(list, env.ui(), outline, {selected ? kInk : rgb(0x1f2430, 120), width}, true);
}

void drawParts(ImDrawList& list, const PanelEnv& env) {
  const app::UiState& ui = env.ui();
  const auto& parts = env.document().parts;
  const std::size_t count = std::min(parts.size(), env.derived.parts.size());
  for (std::size_t i = 0; i < count; ++i) {
    const auto& shape = env.derived.parts[i].shape;
    const document::Part& part = parts[i];
    if (part.recipe.picture != ui.picture || !part.visible) continue;
    const bool selected = part.id == ui.selection;
    if (!shape) {
      drawSpine(list, ui, part.recipe.stroke);
      continue;
    }
    if (app::previewOf(ui, part.id)) continue;
    if (selected && !ui.preview) drawRibs(list, ui, shape->ribs);
    drawOutline(list, env, part, *shape);
    if (selected && !ui.preview) drawSpine(list, ui, shape->spine.points);
  }
}

void drawPreview(ImDrawList& list, const app::UiState& ui) {
  if (!ui.preview) return;
  if (ui.preview->shape) drawRibs(list, ui, ui.preview->shape->ribs);
  drawSpine(list, ui, ui.preview->recipe.stroke);
}

}  // namespace

void drawPictureOverlay(const PanelEnv& env) {
  const app::Rect& view = env.ui().layout.picture;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect({static_cast<float>(view.x), static_cast<float>(view.y)},
                    {static_cast<float>(view.right()), static_cast<float>(view.bottom())}, true);
  drawParts(list, env);
  drawPreview(list, env.ui());
  drawInk(env);
  list.PopClipRect();
}

}  // namespace spineloft::panels
