// Shapes over the picture: the outline, the axis and the handles of the one in hand; and the card with what the tool
// Shapes is told: which shape is next, or from where this picture sees the one in hand.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "engine/io/json_fields.h"
#include "web/commands/intents.h"
#include "web/edit/shaping.h"
#include "web/panels/draw_lines.h"
#include "web/panels/panels.h"
#include "web/panels/section_paint.h"
#include "web/panels/theme.h"
#include "web/panels/widgets.h"

namespace spineloft::panels {
namespace {

void outline(ImDrawList& list, const app::UiState& ui, const std::vector<PicturePoint>& line, bool hot) {
  const ImU32 colour = toolColour(app::ToolKind::Primitive);
  picturePolyline(list, ui, line, {hot ? kGlow : faded(kHalo, 220), hot ? 7.f : 5.f}, true);
  picturePolyline(list, ui, line, {colour, 2.4f}, true);
}

void axis(ImDrawList& list, const app::UiState& ui, const shape::Axis& axis) {
  const ImVec2 from = onCanvas(ui, axis.from), to = onCanvas(ui, axis.to);
  styledLine(list, from, to, {rgb(0xffffff, 190), 4.5f, LineStyle::Solid});
  styledLine(list, from, to, {toolColour(app::ToolKind::Primitive), 1.8f, LineStyle::Dashed});
}

/// A dot at the ends, a cross of arrows in the middle, a square with arrows for width and depth.
void handle(ImDrawList& list, ImVec2 at, app::ShapeHold hold, bool hot, bool chosen) {
  const ImU32 colour = chosen ? kDark : toolColour(app::ToolKind::Primitive);
  const float r = hot ? 8.f : 6.5f;
  if (hold == app::ShapeHold::Width || hold == app::ShapeHold::Depth) {
    list.AddRectFilled({at.x - r - 2, at.y - r - 2}, {at.x + r + 2, at.y + r + 2}, kHalo, 4);
    list.AddRectFilled({at.x - r, at.y - r}, {at.x + r, at.y + r}, colour, 3);
  } else {
    list.AddCircleFilled(at, r + 2, kHalo, 24);
    list.AddCircleFilled(at, r, colour, 24);
  }
  if (hold != app::ShapeHold::Middle) {
    list.AddCircleFilled(at, 2.2f, kHalo, 12);
    return;
  }
  const float arm = r * 0.62f;
  list.AddLine({at.x - arm, at.y}, {at.x + arm, at.y}, kHalo, 2);
  list.AddLine({at.x, at.y - arm}, {at.x, at.y + arm}, kHalo, 2);
}

/// The primitive from the front, upright, with a line that shows its section.
void paintPrimitive(ImDrawList& list, const SectionFrame& frame, shape::Primitive primitive, ImU32 ink) {
  constexpr int kPoints = 32;
  const double width = shape::readyShape(primitive).width, size = 1 / std::max(1.0, width);
  const auto half = [&](double share) { return size * width * shape::halfWidthOf(primitive, share, width / 2); };
  const auto height = [&](double share) { return size * (2 * share - 1); };
  std::vector<SectionPoint> line, other;
  for (int i = 0; i <= kPoints; ++i) {
    const double share = (1 - std::cos(std::numbers::pi * i / kPoints)) / 2;
    line.push_back({half(share), height(share)});
    if (half(share) > 1e-3) other.push_back({-half(share), height(share)});  // a tip once
  }
  line.insert(line.end(), other.rbegin(), other.rend());
  paintOutlines(list, frame, std::array{line}, {ink, faded(ink, 40), 1.8f});
  const bool square = shape::sectionOf(primitive) == sections::SectionPreset::Square;
  std::vector<SectionPoint> section;
  if (square) {
    constexpr double kEdge = 0.35;
    section = {{kEdge * half(0), height(0)}, {kEdge * half(1), height(1)}};
  } else {
    const double at = half(0) > 0 ? 0 : 0.5, flat = 0.22 * half(at);
    for (int i = 0; i <= kPoints; ++i) {
      const double angle = std::numbers::pi * i / kPoints, side = half(0) > 0 ? 1 : -1;
      section.push_back({half(at) * std::cos(angle), height(at) + side * flat * std::sin(angle)});
    }
  }
  paintLine(list, frame, section, {ink, 0, 1.4f});
}

/// A thing seen from there: its nose says where its front is.
void paintSide(ImDrawList& list, ImVec2 c, float r, geometry::ViewFrom from, ImU32 ink) {
  const float body = r * 0.6f, nose = r * 0.32f;
  list.AddCircleFilled(c, body, faded(ink, 40), 24);
  list.AddCircle(c, body, ink, 24, 1.8f);
  ImVec2 way{0, 0};
  if (from == geometry::ViewFrom::Right) way = {-1, 0};
  if (from == geometry::ViewFrom::Left) way = {1, 0};
  if (from == geometry::ViewFrom::Top) way = {0, 1};
  if (way.x == 0 && way.y == 0) return;
  const ImVec2 foot{c.x + way.x * body, c.y + way.y * body}, tip{foot.x + way.x * nose, foot.y + way.y * nose};
  const ImVec2 across{way.y * nose * 0.8f, way.x * nose * 0.8f};
  list.AddTriangleFilled({foot.x + across.x, foot.y + across.y}, {foot.x - across.x, foot.y - across.y}, tip, ink);
}

struct Grid {
  int columns = 1;
  ImVec2 cell;
};

void sideTiles(const PanelEnv& env, const Grid& grid, bool words) {
  const document::PictureEntry* entry = document::findPicture(env.document(), env.ui().picture);
  for (const app::SideName& name : app::sideNames()) {
    if (&name != &app::sideNames().front()) ImGui::SameLine();
    const bool on = entry && entry->view && entry->view->view.from == name.from;
    const std::string id = "side-" + std::string(io::keyOf(name.from));
    const auto paint = [&](ImDrawList& list, ImVec2 centre, float radius, ImU32 ink) {
      paintSide(list, centre, radius, name.from, ink);
    };
    if (tile(env, {id.c_str(), words ? Text(name.label) : Text(""), name.tip, grid.cell, on, name.label}, paint)) {
      env.sink.run(app::setSidePicture, env.ui().picture, on ? std::nullopt : std::optional(name.from));
    }
  }
}

}  // namespace

void primitiveTiles(const PanelEnv& env, const PrimitiveTiles& tiles) {
  int count = 0;
  for (const shape::ReadyShape& name : shape::readyShapes()) {
    if (count++ % tiles.columns != 0) ImGui::SameLine();
    const std::string id = "shape-" + std::string(io::keyOf(name.primitive));
    const auto paint = [&](ImDrawList& list, ImVec2 centre, float radius, ImU32 ink) {
      paintPrimitive(list, {centre, radius}, name.primitive, ink);
    };
    const Text text = tiles.words ? Text(name.label) : Text("");
    const bool on = name.primitive == tiles.chosen;
    if (!tile(env, {id.c_str(), text, name.label, tiles.cell, on, name.label}, paint)) continue;
    if (tiles.next) {
      env.sink.run(app::choosePrimitive, name.primitive);
    } else {
      env.sink.run(app::setPrimitive, app::selectedParts(env.document(), env.ui()), name.primitive);
    }
  }
}

void drawShapes(const PanelEnv& env) {
  const app::UiState& ui = env.ui();
  if (ui.tool != app::ToolKind::Primitive) return;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const auto* fresh =
      ui.preview && !ui.preview->part ? std::get_if<document::ShapeRecipe>(&ui.preview->recipe) : nullptr;
  if (fresh != nullptr) {
    const auto line = pipeline::outlineIn(*fresh, env.document(), ui.picture);
    if (line.ok()) outline(list, ui, line.value(), false);
    axis(list, ui, fresh->shape.axis);
    return;
  }
  if (const document::Part* aside = app::partAside(env.document(), ui)) {
    const auto& side = *document::sideOf(aside->recipe);
    if (!side || side->picture != ui.picture) return;
    for (const auto& line : side->lines) outline(list, ui, line, false);
    return;
  }
  const auto seen = app::shapeShown(env.document(), ui);
  if (!seen) return;
  // The first line in a side picture may align it: what the view shows now is not where the line puts the shape.
  if (!seen->view || ui.inHand.stroke.empty()) outline(list, ui, seen->outline, ui.hover.outlineOfShape);
  if (!seen->view) axis(list, ui, seen->recipe.shape.axis);
  const std::vector<app::ShapeHandle> handles = app::shapeHandles(*seen);
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const int number = static_cast<int>(i);
    const bool chosen = ui.chosen.shape == number, hot = chosen || ui.hover.shape == number;
    const ImVec2 foot = onCanvas(ui, handles[i].at), head = onCanvas(ui, app::heldAt(handles[i], ui.pictureView.zoom));
    styledLine(list, foot, head, {rgb(0xffffff, 190), 4.5f, LineStyle::Solid});
    styledLine(list, foot, head, {toolColour(ui.tool), 1.8f, LineStyle::Solid});
    handle(list, head, handles[i].hold, hot, chosen);
  }
}

double shapeCard(const PanelEnv& env, const app::Rect& room) {
  constexpr double kPadding = 4, kGap = 4, kWords = 54, kIcons = 44;
  const app::UiState& ui = env.ui();
  if (ui.tool != app::ToolKind::Primitive) return 0;
  const bool side = app::shapeElsewhere(env.document(), ui) != nullptr;
  const int count = side ? static_cast<int>(app::sideNames().size()) : static_cast<int>(shape::readyShapes().size());
  const double wide = side ? 84 : 58, inside = room.width - 2 * kPadding;
  const auto needs = [&](int columns, double cell) { return columns * (cell + kGap) - kGap; };
  // One row with words; on a small view two rows of words, or a row of pictures.
  int columns = count;
  bool words = inside >= needs(count, wide);
  if (!words && !side && room.height >= 330 && inside >= needs(count / 2, wide)) {
    words = true;
    columns = count / 2;
  }
  double cell = words ? wide : std::min(kIcons + 6, (inside + kGap) / columns - kGap);
  if (!words && side && inside >= needs(count, 62)) {
    words = true;
    cell = std::min(wide, (inside + kGap) / columns - kGap);
  }
  const double height = words ? kWords : kIcons;
  const int rows = (count + columns - 1) / columns;
  const double width = needs(columns, cell) + 2 * kPadding, tall = rows * (height + kGap) - kGap + 2 * kPadding;
  const app::Rect card{room.right() - width, room.y, width, tall};
  env.ui().overlays.push_back(card);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {kPadding, kPadding});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {kGap, kGap});
  beginFixed("shapes", card);
  const ImVec2 size{static_cast<float>(cell), static_cast<float>(height)};
  if (side) {
    sideTiles(env, {columns, size}, words);
  } else {
    primitiveTiles(env, {columns, size, ui.primitive, words, true});
  }
  ImGui::End();
  ImGui::PopStyleVar(3);
  return tall;
}

}  // namespace spineloft::panels
