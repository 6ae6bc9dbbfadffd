// The sheet for layers: in the solid view with the curves of all layers, and its place as sliders.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "web/commands/intents.h"
#include "web/edit/drawn_rail.h"
#include "web/edit/layer_joints.h"
#include "web/edit/layers.h"
#include "web/edit/placing.h"
#include "web/edit/preview.h"
#include "web/panels/number_text.h"
#include "web/panels/panels.h"
#include "web/panels/theme.h"
#include "web/panels/widgets.h"

namespace spineloft::panels {
namespace {

constexpr int kGrid = 8;  // squares along the sheet's side

/// Draws lines of the sheet's part into the solid view.
class SheetPainter {
 public:
  SheetPainter(const PanelEnv& env, const pipeline::ToWorld& toWorld)
      : ui_(env.ui()), toWorld_(toWorld), list_(*ImGui::GetBackgroundDrawList()) {}

  std::optional<ImVec2> at(ModelPoint p) const {
    const auto c = app::pointOnCanvas(ui_.camera, ui_.layout.solid, toWorld_(p));
    if (!c) return std::nullopt;
    return ImVec2{static_cast<float>(c->x), static_cast<float>(c->y)};
  }

  struct Pen {
    ImU32 colour;
    float width;
    bool closed = true;
  };
  /// Nothing when any of it is behind the eye.
  void line(const stack::Stand& stand, const std::vector<SectionPoint>& points, const Pen& pen) {
    if (!path(stand, points)) return;
    list_.PathStroke(pen.colour, pen.closed ? ImDrawFlags_Closed : 0, pen.width);
  }
  void fill(const stack::Stand& stand, const std::vector<SectionPoint>& points, ImU32 colour) {
    if (path(stand, points)) list_.PathFillConvex(colour);
  }

  ImDrawList& list() { return list_; }

 private:
  bool path(const stack::Stand& stand, const std::vector<SectionPoint>& points) {
    list_.PathClear();
    for (const SectionPoint p : points) {
      const auto c = at(stand.at(p));
      if (!c) return list_.PathClear(), false;
      list_.PathLineTo(*c);
    }
    return true;
  }

  const app::UiState& ui_;
  const pipeline::ToWorld& toWorld_;
  ImDrawList& list_;
};

void paintGround(SheetPainter& paint, const app::Sheet& sheet) {
  const double h = sheet.half;
  const std::vector<SectionPoint> edge{{-h, -h}, {h, -h}, {h, h}, {-h, h}};
  const ImU32 colour = toolColour(app::ToolKind::Layers);
  paint.fill(sheet.stand, edge, faded(colour, 34));
  for (int i = 1; i < kGrid; ++i) {
    const double t = h * (2.0 * i / kGrid - 1);
    paint.line(sheet.stand, {{-h, t}, {h, t}}, {faded(colour, 46), 1, false});
    paint.line(sheet.stand, {{t, -h}, {t, h}}, {faded(colour, 46), 1, false});
  }
  paint.line(sheet.stand, edge, {faded(colour, 210), 2});
}

/// Curves of the other layers thin, those on the sheet thick, and pale what would be copied to it.
void paintLayers(SheetPainter& paint, const app::Sheet& sheet, const document::StackRecipe& shown) {
  const ImU32 colour = toolColour(app::ToolKind::Layers);
  const auto stands = stack::standsOf(shown.planes, shown.rail);
  for (std::size_t i = 0; stands && i < shown.planes.size(); ++i) {
    const stack::Plane& plane = shown.planes[i];
    const stack::Stand& stand = stands.value()[i];
    const bool own = sheet.layer == i && &shown == &sheet.recipe;
    for (const stack::Curve& curve : plane.curves) {
      const std::vector<SectionPoint> outline = stack::outlineOf(curve);
      if (own) paint.line(stand, outline, {faded(kHalo, 220), 6});
      paint.line(stand, outline, {faded(colour, own ? 255 : 150), own ? 3.f : 1.5f});
    }
  }
  if (sheet.layer) return;
  if (const stack::Plane* trace = app::traceOf(sheet)) {
    for (const stack::Curve& curve : trace->curves) {
      paint.line(sheet.stand, stack::outlineOf(curve), {faded(colour, 90), 1.5f});
    }
  }
}

/// It goes up and down.
void paintHandle(ImDrawList& list, ImVec2 at, float radius) {
  list.AddCircleFilled(at, radius + 2, kHalo, 24);
  list.AddCircleFilled(at, radius, toolColour(app::ToolKind::Layers), 24);
  const float size = radius / 11;
  for (const float way : {-1.f, 1.f}) {
    const float tip = at.y + way * 7 * size, foot = tip - way * 5 * size, side = 4.5f * size;
    list.AddTriangleFilled({at.x, tip}, {at.x - side, foot}, {at.x + side, foot}, kOnAccent);
  }
}

/// A bow with a tip at both ends: it leans to and fro about the line from the sheet's middle, which is at `from`.
void paintLeanHandle(ImDrawList& list, ImVec2 at, ImVec2 from, float radius) {
  const ImU32 colour = toolColour(app::ToolKind::Layers);
  list.AddCircleFilled(at, radius + 2, colour, 24);
  list.AddCircleFilled(at, radius, kHalo, 24);
  const float out = std::atan2(at.y - from.y, at.x - from.x), reach = 0.55f * radius, tip = 0.42f * radius;
  constexpr float kHalf = 1.15f;  // radians of the bow
  list.PathArcTo(at, reach, out - kHalf, out + kHalf, 12);
  list.PathStroke(colour, 0, 0.2f * radius);
  for (const float way : {-1.f, 1.f}) {
    const float angle = out + way * kHalf;
    const ImVec2 end{at.x + reach * std::cos(angle), at.y + reach * std::sin(angle)};
    const ImVec2 along{-std::sin(angle) * way * tip, std::cos(angle) * way * tip};
    const ImVec2 beside{std::cos(angle) * tip * 0.8f, std::sin(angle) * tip * 0.8f};
    const ImVec2 left{end.x - beside.x, end.y - beside.y}, right{end.x + beside.x, end.y + beside.y};
    list.AddTriangleFilled({end.x + along.x * 1.2f, end.y + along.y * 1.2f}, left, right, colour);
  }
}

void paintKnobs(SheetPainter& paint, const app::Sheet& sheet, const app::UiState& ui) {
  if (!sheet.onRail()) return;
  const auto isHot = [&](app::SheetHold hold, int joint) { return ui.hover.sheet == hold && ui.hover.joint == joint; };
  const auto middle = paint.at(sheet.stand.origin);
  for (int i = 0; middle && i < static_cast<int>(app::kLeans.size()); ++i) {
    const auto at = paint.at(app::leanKnobOf(sheet, app::kLeans[static_cast<std::size_t>(i)]));
    if (at) paintLeanHandle(paint.list(), *at, *middle, isHot(app::SheetHold::Lean, i) ? 12.f : 10.f);
  }
  if (const auto at = paint.at(app::knobOf(sheet))) {
    paintHandle(paint.list(), *at,
                ui.layers.held == app::SheetHold::Knob || isHot(app::SheetHold::Knob, -1) ? 13.f : 11.f);
  }
}

/// The line that is being drawn as the rail.
void paintRail(ImDrawList& list, const std::vector<app::ClientPoint>& line) {
  for (const auto& [colour, width] : {std::pair{faded(kHalo, 220), 6.f}, {toolColour(app::ToolKind::Layers), 3.f}}) {
    for (const app::ClientPoint p : line) list.PathLineTo({static_cast<float>(p.x), static_cast<float>(p.y)});
    list.PathStroke(colour, 0, width);
  }
}

/// Bands from curve to curve with the marks that a tap changes, full where the curves become each other, and the knobs
/// of forks.
void paintJoints(SheetPainter& paint, const app::LayerJoints& joints, const app::Hover& hover) {
  const ImU32 colour = toolColour(app::ToolKind::Layers);
  ImDrawList& list = paint.list();
  const auto isHot = [&](app::SheetHold hold, std::size_t i) {
    return hover.sheet == hold && hover.joint == static_cast<int>(i);
  };
  for (std::size_t i = 0; i < joints.links.size(); ++i) {
    const app::LayerLink& link = joints.links[i];
    const auto a = paint.at(link.a), b = paint.at(link.b), mark = paint.at(link.mark);
    if (!a || !b || !mark) continue;
    const float radius = isHot(app::SheetHold::Link, i) ? 8.f : 6.f;
    if (link.on) list.AddLine(*a, *b, faded(colour, 120), 4);
    list.AddCircleFilled(*mark, radius + 2, kHalo, 20);
    if (link.on) {
      list.AddCircleFilled(*mark, radius, colour, 20);
    } else {
      list.AddCircle(*mark, radius, colour, 20, 2);
    }
  }
  for (std::size_t i = 0; i < joints.forks.size(); ++i) {
    if (const auto at = paint.at(joints.forks[i].knob())) {
      paintHandle(list, *at, isHot(app::SheetHold::Fork, i) ? 11.f : 9.f);
    }
  }
}

/// Millimetres that the whole rail is long as the part stands; 0: there is nothing to measure by.
double railInMm(const PanelEnv& env, const app::Sheet& sheet) {
  const pipeline::ToWorld toWorld = app::sheetInWorld(env.document(), env.derived, env.ui(), sheet);
  return stack::lengthOf(sheet.recipe.rail) * toWorld.scale * app::mmPerUnit(env.document(), env.derived);
}

SliderTurn placeSlider(const PanelEnv& env, const app::Sheet& sheet, bool ofLayer, float width, float& value) {
  const double mm = railInMm(env, sheet);
  const double number = static_cast<double>(value) * (mm > 0 ? mm : 100);
  const char* text =
      mm > 0 ? (ofLayer ? "Layer to {n} mm" : "Sheet at {n} mm") : (ofLayer ? "Layer to {n} %" : "Sheet at {n} %");
  const std::string shown = numberText(text, number, mm > 0 ? 1 : 0);
  ImGui::SetNextItemWidth(width);
  const float most = static_cast<float>(app::mostAt(sheet));
  return ofLayer ? slider(env, {"##layer", "Layer", 0, most, shown.c_str()}, value)
                 : slider(env, {"##sheet", "Sheet", 0, most, shown.c_str()}, value);
}

void sheetSlider(const PanelEnv& env, const app::Sheet& sheet, float width) {
  auto at = static_cast<float>(sheet.at);
  if (placeSlider(env, sheet, false, width, at).changed) app::placeSheet(env.ui(), sheet, static_cast<double>(at));
}

/// Shows what it would do and does it when it is let go.
void layerSlider(const PanelEnv& env, const app::Sheet& sheet, float width) {
  const document::Part* part = document::findPart(env.document(), sheet.part);
  if (part == nullptr || !sheet.layer) return;
  const app::Preview* held = env.ui().preview && env.ui().preview->part == part->id ? &*env.ui().preview : nullptr;
  const auto* moved = held ? std::get_if<document::StackRecipe>(&held->recipe) : nullptr;
  const bool same = moved != nullptr && *sheet.layer < moved->planes.size();
  auto at = static_cast<float>(same ? moved->planes[*sheet.layer].at : sheet.at);
  const SliderTurn turn = placeSlider(env, sheet, true, width, at);
  if (turn.changed) {
    app::Preview& preview = app::previewPart(env.ui(), *part);
    preview.recipe = app::withMovedLayer(sheet, static_cast<double>(at));
    preview.fresh = false;
  }
  if (!turn.done) return;
  env.ui().preview.reset();
  env.sink.run(app::moveLayer, static_cast<double>(at));
}

}  // namespace

void drawSheet(const PanelEnv& env) {
  const app::UiState& ui = env.ui();
  const auto sheet = app::sheetInHand(env.document(), ui);
  if (!sheet || ui.fliesAlong()) return;
  const pipeline::ToWorld toWorld = app::sheetInWorld(env.document(), env.derived, ui, *sheet);
  const app::Rect& view = ui.layout.solid;
  SheetPainter paint(env, toWorld);
  paint.list().PushClipRect({static_cast<float>(view.x), static_cast<float>(view.y)},
                            {static_cast<float>(view.right()), static_cast<float>(view.bottom())}, true);
  const auto* moved = ui.preview ? std::get_if<document::StackRecipe>(&ui.preview->recipe) : nullptr;
  if (ui.layers.rail.size() > 1) {
    paintRail(paint.list(), ui.layers.rail);
    paint.list().PopClipRect();
    return;
  }
  paintGround(paint, *sheet);
  paintLayers(paint, *sheet, moved ? *moved : sheet->recipe);
  const ImU32 colour = toolColour(app::ToolKind::Layers);
  if (ui.layers.line.size() > 1) {
    paint.line(sheet->stand, ui.layers.line, {faded(kHalo, 220), 6, false});
    paint.line(sheet->stand, ui.layers.line, {colour, 3, false});
  }
  if (ui.layers.line.empty()) {
    app::Sheet seen = *sheet;
    if (moved) seen.recipe = *moved;
    paintJoints(paint, app::jointsOf(env.document(), env.derived, ui, seen), ui.hover);
  }
  if (!app::drawsRail(env.document(), ui)) paintKnobs(paint, *sheet, ui);
  paint.list().PopClipRect();
}

void sheetCard(const PanelEnv& env, const app::Rect& bar, bool atFoot) {
  const auto sheet = app::shownSheet(env.document(), env.ui());
  if (!sheet || !sheet->onRail()) return;
  constexpr double kMargin = 8, kHeight = 44, kGap = 6;
  const bool moves = sheet->layer && !sheet->isFree();  // along the rail
  const double width = std::min(moves ? 420.0 : 230.0, env.ui().layout.solid.width - 2 * kMargin);
  if (!env.ui().layers.at && env.ui().solidRoom.width > 0) env.sink.run(app::seeSheet);  // the first time
  const double left = std::max(env.ui().layout.solid.x + kMargin, bar.right() - width);
  const app::Rect card{left, atFoot ? bar.y - kGap - kHeight : bar.bottom() + kGap, width, kHeight};
  env.ui().overlays.push_back(card);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {8, 6});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushFont(env.fonts.small);
  beginFixed("sheet", card);
  const float inside = static_cast<float>(width) - 16;
  sheetSlider(env, *sheet, moves ? (inside - 6) / 2 : inside);
  if (moves) {
    ImGui::SameLine();
    layerSlider(env, *sheet, (inside - 6) / 2);
  }
  ImGui::End();
  ImGui::PopFont();
  ImGui::PopStyleVar(2);
}

}  // namespace spineloft::panels
