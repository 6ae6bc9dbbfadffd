// Sections over the views: handles on the spine, the place that the pointer is at, a tile on its way.
#include <imgui.h>

#include <algorithm>

#include "web/commands/intents.h"
#include "web/edit/drop_place.h"
#include "web/edit/preview.h"
#include "web/edit/section_editing.h"
#include "web/panels/draw_lines.h"
#include "web/panels/section_paint.h"
#include "web/panels/theme.h"
#include "web/panels/widgets.h"

namespace spineloft::panels {
namespace {

ImVec2 toVec(app::ClientPoint p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }

void handle(ImDrawList& list, ImVec2 at, const sections::SectionShape& shape, bool on, float r) {
  list.AddCircleFilled({at.x, at.y + 1.5f}, r + 1, faded(kDark, 50), 32);
  list.AddCircleFilled(at, r, kHalo, 32);
  list.AddCircle(at, r, on ? kAccent : kSpine, 32, on ? 2.6f : 1.8f);
  paintSection(list, {at, r * 0.55f}, shape, {on ? kAccent : kDark, 0, 1.5f});
}

/// A tile that left the panel follows the pointer; let go over a part, it is that part's section
/// there.
void carriedTile(const PanelEnv& env) {
  app::SectionUi& sections = env.ui().sections;
  const ImGuiIO& io = ImGui::GetIO();
  if (!sections.pressed) return;
  const app::ClientPoint at{io.MousePos.x, io.MousePos.y};
  const bool known = io.MousePos.x > -1e6f;
  // Also in the frame of its release: a slow machine may draw none while it is out of the panel.
  if (known && !sections.board && (sections.carried || !env.ui().layout.panel.contains(at))) {
    sections.carried = sections.pressed;
    sections.carriedTo = at;
  }
  if (!ImGui::IsMouseDown(0)) {
    if (sections.carried) {
      const app::DropPlace place = app::dropPlace(env.document(), env.derived, env.ui(), sections.carriedTo);
      if (place.part) {
        env.sink.run(app::addSection, place.part, place.at, *sections.carried);
      }
      sections.marked.reset();
    }
    sections.pressed.reset();
    sections.carried.reset();
    return;
  }
  if (!known || !sections.carried) return;
  const app::DropPlace place = app::dropPlace(env.document(), env.derived, env.ui(), at);
  sections.marked = place.part && place.part == env.ui().selection ? std::optional(place.at) : std::nullopt;
  handle(*ImGui::GetForegroundDrawList(), toVec(at), *sections.carried, static_cast<bool>(place.part), 20);
}

}  // namespace

void drawSectionOverlay(const PanelEnv& env) {
  app::UiState& ui = env.ui();
  carriedTile(env);
  const document::Part* part = env.selected();
  if (part == nullptr || document::pictureOf(*part) != ui.picture || ui.sections.board) return;
  const app::Preview* preview = app::previewOf(ui, part->id);
  const pipeline::PartShape* shape = preview ? &*preview->shape : app::shapeOf(env.document(), env.derived, part->id);
  if (shape == nullptr || shape->centreLine.size() < 2) return;
  const auto& keys = preview ? preview->loft().loft.sections : document::loftIn(*part).loft.sections;
  const app::Rect& view = ui.layout.picture;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect({static_cast<float>(view.x), static_cast<float>(view.y)},
                    {static_cast<float>(view.right()), static_cast<float>(view.bottom())}, true);
  const auto place = [&](double at) { return onCanvas(ui, app::placeOnSpine(*shape, at)); };
  const float r = ui.touch ? 17.f : 13.f;
  if (ui.hover.along && !ui.sections.marked) {
    list.AddCircleFilled(place(*ui.hover.along), 5, kHalo, 20);
    list.AddCircle(place(*ui.hover.along), 5, kSpine, 20, 2);
  }
  if (ui.sections.marked) {
    list.AddCircleFilled(place(*ui.sections.marked), 9, faded(kGlow, 200), 24);
    list.AddCircle(place(*ui.sections.marked), 9, kDark, 24, 1.5f);
  }
  const std::size_t picked = app::pickedSectionKey(ui, *part);
  for (std::size_t i = 0; keys.size() > 1 && i < keys.size(); ++i) {
    if (i != picked) handle(list, place(keys[i].at), keys[i].shape, false, r);
  }
  if (keys.size() > 1 && picked < keys.size()) {
    handle(list, place(keys[picked].at), keys[picked].shape, true, r);
  }
  list.PopClipRect();
}

}  // namespace spineloft::panels
