// Pulls of the part in hand, over the solid: their lines, the knobs that are dragged, and the line that is drawn.
#include <imgui.h>

#include <cmath>
#include <span>

#include "web/edit/bumping.h"
#include "web/edit/pulling.h"
#include "web/panels/panels.h"
#include "web/panels/theme.h"

namespace spineloft::panels {
namespace {

struct Pen {
  ImU32 colour;
  float width;
};

/// Nothing of what is behind the eye.
void lineOn(ImDrawList& list, const PanelEnv& env, const app::PulledPart& part, std::span<const ModelPoint> line,
            const Pen& pen, ImDrawFlags flags = ImDrawFlags_None) {
  const app::UiState& ui = env.ui();
  list.PathClear();
  for (const ModelPoint p : line) {
    const auto at = app::pointOnCanvas(ui.camera, ui.layout.solid, part.toWorld()(p));
    if (at) list.PathLineTo({static_cast<float>(at->x), static_cast<float>(at->y)});
  }
  list.PathStroke(pen.colour, flags, pen.width);
}

/// A disc with arrows to both ways that it can be dragged.
void knob(ImDrawList& list, const app::PullKnob& knob, bool hot, bool chosen, ImU32 colour) {
  const ImVec2 at{static_cast<float>(knob.at.x), static_cast<float>(knob.at.y)};
  const float r = hot || chosen ? 9.f : 7.f;
  if (chosen) {
    const auto length = static_cast<float>(std::hypot(knob.unit.x, knob.unit.y));
    const ImVec2 way{static_cast<float>(knob.unit.x) / length, static_cast<float>(knob.unit.y) / length};
    for (const float sign : {-1.f, 1.f}) {
      const ImVec2 tip{at.x + sign * way.x * (r + 13), at.y + sign * way.y * (r + 13)};
      const ImVec2 foot{tip.x - sign * way.x * 9, tip.y - sign * way.y * 9};
      for (const auto& [ink, side] : {std::pair{kHalo, 8.f}, {colour, 5.5f}}) {
        const float grown = ink == kHalo ? 3.f : 0.f;
        list.AddTriangleFilled(
            {tip.x + sign * way.x * grown, tip.y + sign * way.y * grown},
            {foot.x - way.y * side - sign * way.x * grown, foot.y + way.x * side - sign * way.y * grown},
            {foot.x + way.y * side - sign * way.x * grown, foot.y - way.x * side - sign * way.y * grown}, ink);
      }
    }
  }
  list.AddCircleFilled(at, r + 2.5f, kHalo, 28);
  list.AddCircleFilled(at, r, chosen ? kDark : colour, 28);
}

}  // namespace

void drawPulls(const PanelEnv& env) {
  const app::UiState& ui = env.ui();
  const app::PulledPart part = app::pulledPart(env.document(), env.derived, ui);
  if (!part) return;
  const ImU32 colour = toolColour(app::ToolKind::Pull);
  const app::Rect& view = ui.layout.solid;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect({static_cast<float>(view.x), static_cast<float>(view.y)},
                    {static_cast<float>(view.right()), static_cast<float>(view.bottom())}, true);
  const std::span<const ModelPoint> drawn(ui.inHand.onSolid);
  const bool isRing = drawn.size() > 1 && app::ringOf(ui.inHand.onSolid);
  const ImDrawFlags closed = isRing ? ImDrawFlags_Closed : ImDrawFlags_None;
  for (const Pen& pen : {Pen{faded(kHalo, 220), 6.f}, Pen{colour, 3.f}}) lineOn(list, env, part, drawn, pen, closed);
  for (const Pen& pen : {Pen{faded(kHalo, 220), 6.f}, Pen{colour, 3.f}}) {
    list.PathClear();
    for (const app::ClientPoint p : ui.inHand.besideSolid) {
      list.PathLineTo({static_cast<float>(p.x), static_cast<float>(p.y)});
    }
    list.PathStroke(pen.colour, 0, pen.width);
  }
  for (std::size_t i = 0; i < part.pulls.size(); ++i) {
    const auto at = app::pullKnob(part, ui, i);
    const bool chosen = ui.chosen.pull == static_cast<int>(i), hot = ui.hover.pull == static_cast<int>(i);
    if (!at || !(at->facing || chosen)) continue;
    const std::span<const ModelPoint> line(part.shape->pulled[i].points);
    for (const Pen& pen : {Pen{faded(kHalo, 170), 4.5f}, Pen{chosen ? kDark : colour, 2.f}}) {
      lineOn(list, env, part, line, pen);
      lineOn(list, env, part, part.shape->pulled[i].ring, pen, ImDrawFlags_Closed);
    }
    knob(list, *at, hot, chosen, colour);
  }
  list.PopClipRect();
}

}  // namespace spineloft::panels
