// The gizmo of the parts in hand: arrows, rings, and knobs for depth and size.
#include <imgui.h>

#include <algorithm>
#include <array>
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

/// A word of a knob with its ground, from its left upper corner.
struct Brief {
  std::string_view text;
  ImVec2 low, high;
  bool meets(ImVec2 otherLow, ImVec2 otherHigh) const {
    return low.x < otherHigh.x && otherLow.x < high.x && low.y < otherHigh.y && otherLow.y < high.y;
  }
};

/// The words of the knobs, for fingers: no pointer rests on them to be told. Each stands below its knob, or above it
/// where another word or knob is below; where both are taken it is left out.
void briefs(const PanelEnv& env, ImDrawList& list, const app::Gizmo& gizmo) {
  const app::Rect& view = env.ui().layout.solid;
  const float radius = static_cast<float>(app::knobRadius(env.ui()));
  std::array<Brief, 5> placed;  // turned three ways, nearer, larger
  std::size_t count = 0;
  const auto isFree = [&](const Brief& word, app::GizmoHandle own) {
    for (std::size_t i = 0; i < count; ++i) {
      if (word.meets(placed[i].low, placed[i].high)) return false;
    }
    return std::ranges::none_of(gizmo.knobs, [&](const app::Gizmo::Knob& knob) {
      const ImVec2 at = vec(knob.at);
      return knob.handle != own && word.meets({at.x - radius, at.y - radius}, {at.x + radius, at.y + radius});
    });
  };
  for (const app::Gizmo::Knob& one : gizmo.knobs) {
    const std::string_view text = shown(app::handleBrief(one.handle));
    if (text.empty() || count == placed.size()) continue;
    const ImVec2 extent = extentOf(env.fonts.small, text, kBriefShare), at = vec(one.at);
    const float x = std::clamp(at.x - extent.x / 2, static_cast<float>(view.x) + 4,
                               static_cast<float>(view.right()) - extent.x - 4);
    for (const float y : {at.y + radius + 2, at.y - radius - 2 - extent.y}) {
      const Brief word{text, {x - 3, y - 1}, {x + extent.x + 3, y + extent.y + 1}};
      if (!isFree(word, one.handle)) continue;
      list.AddRectFilled(word.low, word.high, faded(kSurface, 215), 5);
      drawLine(list, {env.fonts.small, {x, y}, kInk, kBriefShare}, text);
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
