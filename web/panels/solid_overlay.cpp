// What is drawn over the solid: the spine of the selected part with the handles of its depth, and the sheet for layers.
#include <imgui.h>

#include <vector>

#include "web/edit/depth_dots.h"
#include "web/edit/editing.h"
#include "web/edit/placing.h"
#include "web/edit/preview.h"
#include "web/panels/panels.h"
#include "web/panels/theme.h"

namespace spineloft::panels {
namespace {

struct Projector {
  const app::UiState& ui;
  pipeline::ToWorld toWorld;
  std::optional<ImVec2> operator()(ModelPoint p) const {
    const auto at = app::pointOnCanvas(ui.camera, ui.layout.solid, toWorld(p));
    if (!at) return std::nullopt;
    return ImVec2{static_cast<float>(at->x), static_cast<float>(at->y)};
  }
};

void drawLine(ImDrawList& list, const Projector& at, const std::vector<ModelPoint>& line) {
  for (const auto& [colour, width] : {std::pair{faded(kHalo, 220), 6.f}, {kSpine, 3.f}}) {
    list.PathClear();
    for (const ModelPoint& p : line) {
      if (const auto c = at(p)) list.PathLineTo(*c);
    }
    list.PathStroke(colour, 0, width);
  }
}

void drawHandle(ImDrawList& list, ImVec2 at, bool hot, bool chosen) {
  const ImU32 colour = chosen ? kDark : kSpine;
  list.AddCircleFilled(at, hot ? 8.5f : 7.f, kHalo, 24);
  list.AddCircleFilled(at, hot ? 6.5f : 5.f, colour, 24);
  if (!hot) return;
  // It goes up and down from here.
  for (const float way : {-1.f, 1.f}) {
    const ImVec2 tip{at.x, at.y + way * 19};
    list.AddTriangleFilled(tip, {tip.x - 5, tip.y - way * 6}, {tip.x + 5, tip.y - way * 6}, colour);
  }
}

/// Dots of the depth of a piece of a line drawing: pins filled, free places hollow.
void drawDots(const PanelEnv& env) {
  const app::UiState& ui = env.ui();
  const std::vector<app::DepthDot> dots = app::depthDots(env.document(), env.derived, ui);
  if (dots.empty()) return;
  const app::Rect& view = ui.layout.solid;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect({static_cast<float>(view.x), static_cast<float>(view.y)},
                    {static_cast<float>(view.right()), static_cast<float>(view.bottom())}, true);
  for (std::size_t i = 0; i < dots.size(); ++i) {
    const ImVec2 at{static_cast<float>(dots[i].seen.x), static_cast<float>(dots[i].seen.y)};
    const bool hot = static_cast<int>(i) == (ui.inHand.depth >= 0 ? ui.inHand.depth : ui.hover.depth);
    const float r = hot ? 7.f : 5.f;
    const ImU32 colour = toolColour(app::ToolKind::Lines);
    list.AddCircleFilled(at, r + 2, kHalo, 24);
    list.AddCircleFilled(at, r, colour, 24);
    if (!dots[i].pinned && !hot) list.AddCircleFilled(at, r - 2, kHalo, 24);
  }
  list.PopClipRect();
}

}  // namespace

void drawSolidOverlay(const PanelEnv& env) {
  const app::UiState& ui = env.ui();
  drawSheet(env);
  drawPulls(env);
  drawBridge(env);
  drawSlicesInSolid(env);
  drawDots(env);
  const app::Subject subject = app::subjectOf(env.document(), env.derived, ui.selection);
  if (ui.tool != app::ToolKind::Spine || !subject || !subject.part->visible) return;
  const document::PictureEntry* entry = document::findPicture(env.document(), document::pictureOf(*subject.part));
  if (entry == nullptr) return;
  const app::Preview* preview = app::previewOf(ui, subject.part->id);
  const app::Subject shown{subject.part, preview ? &*preview->shape : subject.shape};
  const app::Rect& view = ui.layout.solid;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect({static_cast<float>(view.x), static_cast<float>(view.y)},
                    {static_cast<float>(view.right()), static_cast<float>(view.bottom())}, true);
  const Projector at{ui, *app::shownCopies(ui, *subject.part, entry->size).begin()};
  drawLine(list, at, shown.shape->centreLine);
  const std::vector<ModelPoint> handles = app::depthHandles(shown);
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const int handle = static_cast<int>(i);
    const bool hot = handle == ui.inHand.depth || (ui.inHand.depth < 0 && handle == ui.hover.depth);
    if (const auto c = at(handles[i])) drawHandle(list, *c, hot, handle == ui.chosen.handle);
  }
  list.PopClipRect();
}

}  // namespace spineloft::panels
