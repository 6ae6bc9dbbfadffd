// The gizmo of the parts in hand: arrows, rings, and knobs for depth and size.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>

#include "web/edit/gizmo.h"
#include "web/edit/placing.h"
#include "web/panels/panels.h"
#include "web/panels/theme.h"
#include "web/panels/widgets.h"

namespace spineloft::panels {
namespace {

constexpr float kBriefShare = 0.92f;  // of the small font: between knobs there is little room
constexpr float kTail = 0.62f;        // of an arrow that is not drawn
constexpr std::array<ImU32, 3> kAxisColour = {rgb(0xd0412f), rgb(0x2f9a4b), rgb(0x2b62d9)};

ImVec2 vec(app::ClientPoint p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }

bool isMove(app::GizmoHandle handle) {
  return handle == app::GizmoHandle::MoveX || handle == app::GizmoHandle::MoveY || handle == app::GizmoHandle::MoveZ;
}

void arrow(ImDrawList& list, ImVec2 from, ImVec2 to, ImU32 colour, float size) {
  const float dx = to.x - from.x, dy = to.y - from.y;
  const float length = std::max(1.f, std::sqrt(dx * dx + dy * dy));
  const float ux = dx / length, uy = dy / length;
  const ImVec2 neck{to.x - ux * size * 0.8f, to.y - uy * size * 0.8f};
  // Only its end: what it moves is in sight.
  const ImVec2 tail{from.x + (neck.x - from.x) * kTail, from.y + (neck.y - from.y) * kTail};
  list.AddLine(tail, neck, faded(kHalo, 200), 6);
  list.AddLine(tail, neck, colour, 3.2f);
  const ImVec2 tip{to.x + ux * size * 0.7f, to.y + uy * size * 0.7f};
  const ImVec2 a{neck.x - uy * size * 0.75f, neck.y + ux * size * 0.75f};
  const ImVec2 b{neck.x + uy * size * 0.75f, neck.y - ux * size * 0.75f};
  list.AddTriangleFilled(tip, a, b, colour);
  list.AddTriangle(tip, a, b, faded(kHalo, 220), 1.4f);
}

void ring(ImDrawList& list, const std::vector<app::ClientPoint>& points, ImU32 colour, bool hot) {
  for (const auto& [ink, width] : {std::pair{faded(kHalo, 150), hot ? 6.f : 4.f}, {colour, hot ? 3.4f : 1.8f}}) {
    list.PathClear();
    for (const app::ClientPoint p : points) list.PathLineTo(vec(p));
    list.PathStroke(ink, ImDrawFlags_Closed, width);
  }
}

/// A round knob with a sign drawn in it.
void knob(const PanelEnv& env, ImDrawList& list, ImVec2 at, ImU32 colour, const char* icon, bool hot) {
  const float radius = static_cast<float>(app::knobRadius(env.ui())) + (hot ? 2.f : 0.f);
  list.AddCircleFilled(at, radius + 1.5f, faded(kHalo, 235), 32);
  list.AddCircleFilled(at, radius, hot ? colour : kHalo, 32);
  list.AddCircle(at, radius, colour, 32, 2);
  ImFont* font = env.fonts.icons;
  const float size = radius * 1.3f;
  const ImVec2 extent = font->CalcTextSizeA(size, FLT_MAX, 0, icon);
  list.AddText(font, size, {at.x - extent.x / 2, at.y - extent.y / 2}, hot ? kHalo : colour, icon);
}

/// The words of the knobs, for fingers: no pointer rests on them to be told. Each stands below its knob, or above or
/// beside it where something else is; where all is taken it is left out.
void briefs(const PanelEnv& env, ImDrawList& list, const app::Gizmo& gizmo) {
  const app::UiState& ui = env.ui();
  const app::Rect& view = ui.layout.solid;
  const double radius = app::knobRadius(ui);
  std::array<app::Rect, 5> placed;  // turned three ways, nearer, larger
  std::size_t count = 0;
  const auto isFree = [&](const app::Rect& word, app::GizmoHandle own) {
    const auto isClearOf = [&](const app::Rect& other) { return !word.meets(other); };
    return view.contains({word.x, word.y}) && view.contains({word.right(), word.bottom()}) &&
           std::ranges::all_of(std::span(placed).first(count), isClearOf) &&
           std::ranges::all_of(ui.overlays, isClearOf) &&
           std::ranges::all_of(ui.controls,
                               [&](const app::Control& control) {
                                 return control.kind != app::Control::Kind::Words || isClearOf(control.at);
                               }) &&
           std::ranges::all_of(gizmo.knobs, [&](const app::Gizmo::Knob& knob) {
             return knob.handle == own || isClearOf(app::Rect{knob.at.x, knob.at.y, 0, 0}.inset(-radius));
           });
  };
  for (const app::Gizmo::Knob& one : gizmo.knobs) {
    const std::string_view text = shown(app::handleBrief(one.handle));
    if (text.empty() || count == placed.size()) continue;
    const ImVec2 extent = extentOf(env.fonts.small, text, kBriefShare);
    const double width = extent.x + 6, height = extent.y + 2;
    const double across = std::clamp(one.at.x - width / 2, view.x + 1, view.right() - width - 1);
    const double level = one.at.y - height / 2, away = radius + 2;
    for (const app::ClientPoint at : {app::ClientPoint{across, one.at.y + away - 1},
                                      {across, one.at.y - away + 1 - height},
                                      {one.at.x + away, level},
                                      {one.at.x - away - width, level}}) {
      const app::Rect word{at.x, at.y, width, height};
      if (!isFree(word, one.handle)) continue;
      const ImVec2 low = vec(at);
      list.AddRectFilled(low, {low.x + static_cast<float>(width), low.y + static_cast<float>(height)},
                         faded(kSurface, 215), 5);
      drawLine(list, {env.fonts.small, {low.x + 3, low.y + 1}, kInk, kBriefShare}, text);
      placed[count++] = word;
      break;
    }
  }
}

/// What the handle under the pointer does, beside the gizmo.
void words(const PanelEnv& env, ImDrawList& list, const app::Gizmo& gizmo, app::GizmoHandle handle) {
  const std::string_view text = shown(app::handleWords(handle));
  if (text.empty()) return;
  ImFont* font = env.fonts.small;
  const ImVec2 extent = extentOf(font, text);
  const app::Rect& view = env.ui().layout.solid;
  const float x = std::clamp(static_cast<float>(gizmo.at.x) - extent.x / 2, static_cast<float>(view.x) + 12,
                             static_cast<float>(view.right()) - extent.x - 12);
  const float y = std::clamp(static_cast<float>(gizmo.at.y + gizmo.radius * 1.3), static_cast<float>(view.y) + 8,
                             static_cast<float>(view.bottom()) - 26);
  list.AddRectFilled({x - 9, y - 4}, {x + extent.x + 9, y + extent.y + 4}, faded(kDark, 225), 8);
  drawLine(list, {font, {x, y}, kHalo}, text);
}

}  // namespace

void drawPlaceOverlay(const PanelEnv& env) {
  app::UiState& ui = env.ui();
  const std::optional<app::Gizmo> gizmo = app::shownGizmo(env.document(), env.derived, ui);
  if (!gizmo) return;
  const app::Rect& view = ui.layout.solid;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect({static_cast<float>(view.x), static_cast<float>(view.y)},
                    {static_cast<float>(view.right()), static_cast<float>(view.bottom())}, true);
  const bool holding = ui.held != app::GizmoHandle::None;
  const app::GizmoHandle hot = holding ? ui.held : ui.hover.gizmo;
  const std::string turnIcon = iconText("rotate-3d"), depthIcon = iconText("move-3d"), scaleIcon = iconText("scaling"),
                    moveIcon = iconText("move");
  for (int axis = 0; axis < 3; ++axis) {
    const bool lit = app::axisOf(hot) == axis && !isMove(hot);
    if (holding && !lit) continue;
    ring(list, gizmo->ring(ui.camera, view, axis), kAxisColour[static_cast<std::size_t>(axis)], lit);
  }
  for (const app::Gizmo::Knob& one : gizmo->knobs) {
    const bool lit = one.handle == hot;
    if (holding && !lit) continue;
    const int axis = app::axisOf(one.handle);
    const ImU32 colour = axis >= 0 ? kAxisColour[static_cast<std::size_t>(axis)] : kDark;
    if (isMove(one.handle)) {
      arrow(list, vec(gizmo->at), vec(one.at), colour, (ui.touch ? 15.f : 11.f) + (lit ? 3.f : 0.f));
    } else if (one.handle == app::GizmoHandle::Plane && !lit) {
      list.AddCircleFilled(vec(one.at), 5, faded(kHalo, 220), 20);
      list.AddCircle(vec(one.at), 5, colour, 20, 2);
    } else {
      const std::string& icon = axis >= 0                               ? turnIcon
                                : one.handle == app::GizmoHandle::Scale ? scaleIcon
                                : one.handle == app::GizmoHandle::Depth ? depthIcon
                                                                        : moveIcon;
      knob(env, list, vec(one.at), colour, icon.c_str(), lit);
    }
  }
  if (ui.touch && !holding) briefs(env, list, *gizmo);
  words(env, list, *gizmo, hot);
  list.PopClipRect();
}

}  // namespace spineloft::panels
