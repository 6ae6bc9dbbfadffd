// Where a solid could not be made: a mark in the picture and one in the solid view, at the place that the solver named.
#include <imgui.h>

#include <algorithm>

#include "web/edit/placing.h"
#include "web/edit/solid_editing.h"
#include "web/panels/draw_lines.h"
#include "web/panels/panels.h"
#include "web/panels/theme.h"
#include "web/ui/views.h"

namespace spineloft::panels {
namespace {

void mark(ImDrawList& list, ImVec2 at) {
  list.AddCircle(at, 17, faded(kHalo, 235), 40, 7);
  list.AddCircle(at, 17, kFailure, 40, 3.5f);
  const ImVec2 badge{at.x + 13, at.y - 13};
  list.AddCircleFilled(badge, 9.5f, kFailure, 28);
  list.AddRectFilled({badge.x - 1.4f, badge.y - 5.5f}, {badge.x + 1.4f, badge.y + 1.2f}, kHalo, 1);
  list.AddCircleFilled({badge.x, badge.y + 4.2f}, 1.7f, kHalo, 12);
}

/// Clips what `draw` draws to a view.
template <class Draw>
void within(const app::Rect& view, const Draw& draw) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect({static_cast<float>(view.x), static_cast<float>(view.y)},
                    {static_cast<float>(view.right()), static_cast<float>(view.bottom())}, true);
  draw(list);
  list.PopClipRect();
}

}  // namespace

void drawFailureInSolid(const PanelEnv& env) {
  const app::UiState& ui = env.ui();
  within(ui.layout.solid, [&](ImDrawList& list) {
    for (const pipeline::DerivedStep& step : env.derived.steps) {
      if (!step.failure || !step.at) continue;
      const auto at = app::pointOnCanvas(ui.camera, ui.layout.solid, *step.at);
      if (at) mark(list, {static_cast<float>(at->x), static_cast<float>(at->y)});
    }
    for (const pipeline::DerivedPart& part : env.derived.parts) {
      const auto where = pipeline::crossingInWorld(env.document(), part);
      const auto at = where ? app::pointOnCanvas(ui.camera, ui.layout.solid, *where) : std::nullopt;
      if (at) mark(list, {static_cast<float>(at->x), static_cast<float>(at->y)});
    }
  });
}

void drawFailureInPicture(const PanelEnv& env) {
  const app::UiState& ui = env.ui();
  within(ui.layout.picture, [&](ImDrawList& list) {
    for (const pipeline::DerivedStep& step : env.derived.steps) {
      const document::Part* part = document::findPart(env.document(), step.faulty);
      if (!step.failure || !step.at || part == nullptr || document::pictureOf(*part) != ui.picture) continue;
      const document::PictureEntry* entry = document::findPicture(env.document(), ui.picture);
      if (entry == nullptr) continue;
      const ModelPoint at = app::shownCopies(ui, *part, entry->size).begin()->toModel(*step.at);
      mark(list, onCanvas(ui, {at.x, -at.y}));
    }
    for (const pipeline::DerivedPart& each : env.derived.parts) {
      const document::Part* part = document::findPart(env.document(), each.id);
      if (!each.crossesAt || part == nullptr || document::pictureOf(*part) != ui.picture) continue;
      mark(list, onCanvas(ui, {each.crossesAt->x, -each.crossesAt->y}));
    }
  });
}

}  // namespace spineloft::panels
