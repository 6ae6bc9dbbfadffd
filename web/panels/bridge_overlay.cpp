// The bridge in hand over the solid: its rims with the knobs that move them, and the way of one that is drawn.
#include <imgui.h>

#include <vector>

#include "web/edit/bridging.h"
#include "web/panels/panels.h"
#include "web/panels/theme.h"

namespace spineloft::panels {
namespace {

ImVec2 toImGui(app::ClientPoint p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }

struct Pen {
  ImU32 colour;
  float width;
};

void strokeLine(ImDrawList& list, const std::vector<app::ClientPoint>& line, const Pen& pen, ImDrawFlags flags) {
  list.PathClear();
  for (const app::ClientPoint p : line) list.PathLineTo(toImGui(p));
  list.PathStroke(pen.colour, flags, pen.width);
}

/// Nothing of what is behind the eye.
std::vector<app::ClientPoint> rimOnCanvas(const app::ShownBridge& bridge, const app::UiState& ui, std::size_t end) {
  std::vector<app::ClientPoint> line;
  for (const ModelPoint p : bridge.shape->rims[end].points) {
    const auto at = app::pointOnCanvas(ui.camera, ui.layout.solid, (*bridge.copies.begin())(p));
    if (at) line.push_back(*at);
  }
  return line;
}

}  // namespace

void drawBridge(const PanelEnv& env) {
  const app::UiState& ui = env.ui();
  if (ui.tool != app::ToolKind::Bridge) return;
  const ImU32 colour = toolColour(ui.tool);
  const app::Rect& view = ui.layout.solid;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect(toImGui({view.x, view.y}), toImGui({view.right(), view.bottom()}), true);
  for (const Pen& pen : {Pen{faded(kHalo, 220), 6.f}, Pen{colour, 3.f}}) {
    strokeLine(list, ui.inHand.besideSolid, pen, ImDrawFlags_None);
  }
  if (!ui.inHand.besideSolid.empty()) {
    list.AddCircleFilled(toImGui(ui.inHand.besideSolid.front()), 7.5f, kHalo, 28);
    list.AddCircleFilled(toImGui(ui.inHand.besideSolid.front()), 5, colour, 28);
  }
  const app::ShownBridge bridge = app::bridgeInHand(env.document(), env.derived, ui);
  for (int end = 0; bridge && end < 2; ++end) {
    const std::vector<app::ClientPoint> rim = rimOnCanvas(bridge, ui, static_cast<std::size_t>(end));
    for (const Pen& pen : {Pen{faded(kHalo, 170), 4.5f}, Pen{colour, 2.f}}) {
      strokeLine(list, rim, pen, ImDrawFlags_Closed);
    }
    const auto at = app::rimKnob(bridge, ui, end);
    if (!at || !app::rimFaces(bridge, ui, end)) continue;
    const float radius = ui.hover.rim == end ? 9.f : 7.f;
    list.AddCircleFilled(toImGui(*at), radius + 2.5f, kHalo, 28);
    list.AddCircleFilled(toImGui(*at), radius, colour, 28);
  }
  list.PopClipRect();
}

}  // namespace spineloft::panels
