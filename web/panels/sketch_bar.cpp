// Drawing on paper: the ink under the pen, and a card with pen, eraser, what they are set to, and the
// way on to the spine.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "web/commands/intents.h"
#include "web/panels/draw_lines.h"
#include "web/panels/theme.h"
#include "web/panels/widgets.h"

namespace spineloft::panels {
namespace {

constexpr float kRoomForAll = 630;  // CSS pixels of the view from which sizes and inks are all shown
constexpr float kMargin = 10;
constexpr const char* kSpineLine = "Line";

ImU32 colourOf(const std::array<std::uint8_t, 3>& c) { return IM_COL32(c[0], c[1], c[2], 255); }

float sideOf(const PanelEnv& env) { return env.ui().touch ? 44.f : 34.f; }

bool erasing(const PanelEnv& env) { return env.ui().tool == app::ToolKind::Eraser; }

bool drawing(const PanelEnv& env) { return env.ui().tool == app::ToolKind::Pen || erasing(env); }

/// Whether the card is a column at the left side, as the other buttons are one at the right: a low view has no room at
/// its foot.
bool isColumn(const PanelEnv& env) { return app::buttonsAtSide(env.ui().layout.picture); }

/// Whether the card has room for sizes and inks, which else are menus.
bool showsAll(const PanelEnv& env) {
  return !isColumn(env) && env.ui().layout.picture.width >= kRoomForAll && !env.ui().touch;
}

/// A dot in a square that can be pressed.
struct DotButton {
  const char* id;
  std::string_view words;  ///< what the mouse is told, too
  float radius;
  ImU32 colour;
  bool on;
};
bool dotButton(const PanelEnv& env, const DotButton& what) {
  const auto& [id, words, radius, colour, on] = what;
  const float side = sideOf(env);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool pressed = ImGui::InvisibleButton(id, {side, side});
  registerControl(env, app::Control::Kind::Button, words, true, on);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (on || ImGui::IsItemHovered()) {
    list.AddRectFilled(at, {at.x + side, at.y + side}, on ? kAccentSoft : kHover, 8);
  }
  const ImVec2 centre{at.x + side / 2, at.y + side / 2};
  list.AddCircleFilled(centre, radius, colour, 24);
  if (on) list.AddCircle(centre, std::min(radius + 3.5f, side / 2 - 2), kAccent, 32, 1.6f);
  tooltip(words);
  return pressed;
}

constexpr std::array kDotRadii = {2.5f, 4.5f, 7.5f};

void sizes(const PanelEnv& env) {
  const std::size_t chosen = app::sizeInHand(env.ui());
  const ImU32 colour = erasing(env) ? kMuted : colourOf(env.ui().sketching.colour);
  for (std::size_t i = 0; i < app::kPenSizes.size(); ++i) {
    if (i > 0) ImGui::SameLine();
    const std::string id(app::kPenSizes[i]);
    const char* words = i == 0 ? "Fine" : i == 1 ? "Medium" : "Bold";
    if (dotButton(env, {id.c_str(), words, kDotRadii[i], colour, chosen == i})) {
      env.sink.run(app::setPenSize, i);
    }
  }
}

/// `columns`: so many in a row.
void inks(const PanelEnv& env, std::size_t columns = app::kInks.size()) {
  std::size_t at = 0;
  for (const app::Ink& ink : app::kInks) {
    if (at++ % columns != 0) ImGui::SameLine();
    const bool on = !erasing(env) && env.ui().sketching.colour == ink.colour;
    if (dotButton(env, {ink.value.data(), ink.label, 8, colourOf(ink.colour), on})) {
      env.sink.run(app::setPenColour, ink.colour);
    }
  }
}

/// Width of `count` buttons in a row.
float rowWidth(const PanelEnv& env, std::size_t count) { return static_cast<float>(count) * (sideOf(env) + 2) - 2; }

/// Of the button of the next step, which says its words where the view has room for them.
float spineWidth(const PanelEnv& env) {
  if (env.ui().layout.picture.width < 460) return sideOf(env);
  return extentOf(env.fonts.text, shown(kSpineLine)).x + 46;
}

/// Of the card with so many sizes and inks, or the buttons of their menus.
float widthWith(const PanelEnv& env, std::size_t settings) {
  const float lines = settings == 0 ? 0.f : showsAll(env) ? 18.f : 9.f;
  return rowWidth(env, 2 + settings) + lines + 2 + spineWidth(env) + 9 + 8;
}

double roomIn(const PanelEnv& env) { return env.ui().layout.picture.width - 2 * kMargin; }

/// How many sizes and inks the card has, or buttons of their menus; none where there is no room.
std::size_t settingsShown(const PanelEnv& env) {
  if (!drawing(env)) return 0;
  const std::size_t wanted = showsAll(env) ? app::kPenSizes.size() + app::kInks.size() : 2;
  return roomIn(env) < widthWith(env, wanted) ? 0 : wanted;
}

/// What a column has besides pen and eraser. The top bar has the spine too.
struct Column {
  bool settings = false, spine = false;
  int cells() const { return 2 + (settings ? 1 : 0) + (spine ? 1 : 0); }
};
Column columnIn(const PanelEnv& env, int most) {
  Column out;
  out.settings = drawing(env) && most >= 3;
  out.spine = out.cells() < most;
  return out;
}
constexpr float kColumnEdge = 4;

/// Cells of which there is room one below the other.
int cellsIn(const PanelEnv& env) {
  const double room = env.ui().layout.picture.height - 2 * kColumnEdge - 8 + 2;
  return static_cast<int>(room / (sideOf(env) + 2));
}

app::Rect columnRect(const PanelEnv& env) {
  const int most = cellsIn(env);
  if (most < 2) return {};
  const app::Rect& view = env.ui().layout.picture;
  const double side = sideOf(env), height = columnIn(env, most).cells() * (side + 2) - 2 + 8;
  const double foot = std::min<double>(kMargin, (view.height - height) / 2);
  return {view.x + kColumnEdge, view.bottom() - foot - height, side + 8, height};
}

/// The next step: filled once there is something that a spine could go through.
void spineButton(const PanelEnv& env, float width, bool next) {
  const float side = sideOf(env);
  const ImVec2 at = ImGui::GetCursorScreenPos(), end{at.x + width, at.y + side};
  const bool pressed = ImGui::InvisibleButton("bone", {width, side});
  const bool on = env.ui().tool == app::ToolKind::Draw;
  registerControl(env, app::Control::Kind::Button, kSpineLine, true, on);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (on && !next) markOn(list, at, end, kAccentSoft);
  if (next || (!on && ImGui::IsItemHovered())) list.AddRectFilled(at, end, next ? kAccent : kHover, 8);
  const ImU32 ink = next ? kOnAccent : on ? kAccent : kInk;
  const bool words = width > side + 1;
  ImFont* icons = env.fonts.icons;
  const float scale = ImGui::GetIO().FontGlobalScale, size = icons->FontSize * scale;
  const float left = words ? at.x + 9 : at.x + (side - size) / 2;
  list.AddText(icons, size, {left, at.y + (side - size) / 2}, ink, iconText("spline"));
  if (words) {
    ImFont* font = env.fonts.text;
    const float height = font->FontSize * scale;
    drawLine(list, {font, {left + size + 7, at.y + (side - height) / 2}, ink}, shown(kSpineLine));
  }
  tooltip("Draw a bone: one line along the middle of what you drew");
  if (pressed) env.sink.run("draw");
}

void line(const PanelEnv& env) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::Dummy({5, sideOf(env)});
  ImGui::GetWindowDrawList()->AddLine({at.x + 2, at.y + 6}, {at.x + 2, at.y + sideOf(env) - 6}, kLine, 1);
  ImGui::SameLine();
}

/// Sizes and below them inks beside a column, three in a row.
void menuBeside(const PanelEnv& env, const app::Rect& card) {
  const double cell = sideOf(env) + 2., inkRows = std::ceil(app::kInks.size() / 3.);
  const double width = 3 * cell - 2 + 8, height = (1 + inkRows) * cell - 2 + 8;
  const double highest = env.ui().layout.picture.y + kColumnEdge;
  beginCard(env, "pen menu", {card.right() + 6, std::max(highest, card.bottom() - height), width, height});
  sizes(env);
  inks(env, 3);
  endCard();
}

/// The sizes or the inks above the card, where that has no room for them.
void openMenu(const PanelEnv& env, const app::Rect& card) {
  const app::PenMenu menu = env.ui().sketching.menu;
  if (menu == app::PenMenu::None) return;
  if (isColumn(env)) return menuBeside(env, card);
  const bool size = menu == app::PenMenu::Size;
  const double width = rowWidth(env, size ? app::kPenSizes.size() : app::kInks.size()) + 8.;
  const double height = sideOf(env) + 8.;
  beginCard(env, "pen menu", {card.x, card.y - height - 6, width, height});
  size ? sizes(env) : inks(env);
  endCard();
}

/// The ink as wide as the pen, for the menu of both.
void settingsCell(const PanelEnv& env) {
  app::PenMenu& open = env.ui().sketching.menu;
  const ImU32 ink = erasing(env) ? kMuted : colourOf(env.ui().sketching.colour);
  const float radius = kDotRadii[app::sizeInHand(env.ui())] + 2;
  const bool pressed = dotButton(env, {"settings", "Size and ink", radius, ink, open != app::PenMenu::None});
  if (pressed) open = open == app::PenMenu::None ? app::PenMenu::Both : app::PenMenu::None;
}

void settings(const PanelEnv& env, bool all) {
  line(env);
  if (all) {
    sizes(env);
    ImGui::SameLine();
    line(env);
    inks(env);
    return;
  }
  const auto toggle = [&](app::PenMenu menu) {
    app::PenMenu& open = env.ui().sketching.menu;
    open = open == menu ? app::PenMenu::None : menu;
  };
  const app::PenMenu open = env.ui().sketching.menu;
  const ImU32 ink = erasing(env) ? kMuted : colourOf(env.ui().sketching.colour);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (dotButton(env, {"size", "Pen size", 0, kInk, false})) toggle(app::PenMenu::Size);
  // A dash as wide as the pen, so that it is not taken for a colour.
  const float side = sideOf(env), width = 2 * kDotRadii[app::sizeInHand(env.ui())] - 2;
  ImGui::GetWindowDrawList()->AddLine({at.x + 10, at.y + side - 11}, {at.x + side - 10, at.y + 11}, kInk, width);
  ImGui::SameLine();
  if (dotButton(env, {"ink", "Ink", 8, ink, open == app::PenMenu::Colour})) toggle(app::PenMenu::Colour);
}

/// How much an eraser or a scribble would cover that began here.
void brushRing(const PanelEnv& env, app::ClientPoint at) {
  const app::UiState& ui = env.ui();
  const double radius = erasing(env) ? app::kEraserRadii[ui.sketching.eraserSize] * ui.pictureView.zoom : ui.edit.brush;
  const ImVec2 centre{static_cast<float>(at.x), static_cast<float>(at.y)};
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddCircle(centre, static_cast<float>(radius) + 1, faded(kHalo, 160), 0, 1);
  list.AddCircle(centre, static_cast<float>(radius), kMuted, 0, 1.2f);
}

}  // namespace

void drawInk(const PanelEnv& env) {
  const app::UiState& ui = env.ui();
  if (!ui.sketching.stroke) {
    if (ui.hover.brush) brushRing(env, *ui.hover.brush);
    return;
  }
  const image::SketchStroke& stroke = *ui.sketching.stroke;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImU32 colour = stroke.erase ? kHalo : colourOf(stroke.colour);
  const double zoom = ui.pictureView.zoom;
  ImVec2 before;
  bool first = true;
  for (const image::InkPoint& p : image::inkLine(stroke)) {
    const double unit = image::kInkUnit;
    const ImVec2 at = onCanvas(ui, {p.x / unit, p.y / unit});
    const float radius = static_cast<float>(p.radius / unit * zoom);
    if (!first) list.AddLine(before, at, colour, 2 * radius);
    if (radius > 0.8f || first) list.AddCircleFilled(at, radius, colour);
    before = at;
    first = false;
  }
  if (!stroke.erase) return;
  list.AddCircle(before, static_cast<float>(stroke.radius * zoom), kMuted, 0, 1.2f);
}

app::Rect sketchBarRect(const PanelEnv& env) {
  if (app::shownSketch(env.document(), env.ui()) == nullptr || env.ui().sections.board) return {};
  const app::Rect& view = env.ui().layout.picture;
  if (isColumn(env)) return columnRect(env);
  const float side = sideOf(env), width = widthWith(env, settingsShown(env));
  const app::Rect card{view.x + kMargin, view.bottom() - side - 8 - kMargin, width, side + 8.};
  if (roomIn(env) < width || view.height < card.height + 2 * kMargin) return {};
  return card;
}

void drawSketchBar(const PanelEnv& env) {
  const document::PictureEntry* sketch = app::shownSketch(env.document(), env.ui());
  const app::Rect card = sketchBarRect(env);
  const bool column = isColumn(env);
  env.ui().barLeft = column && card.width > 0 ? card.right() + kColumnEdge - env.ui().layout.picture.x : 0;
  if (card.width <= 0) return;
  const float side = sideOf(env);
  const bool hasParts = std::ranges::any_of(
      env.document().parts, [&](const document::Part& part) { return document::pictureOf(part) == sketch->id; });
  const bool next = drawing(env) && !hasParts && app::looksFinished(*sketch);
  beginCard(env, "sketch bar", card);
  commandButton(env, "pen", side);
  if (!column) ImGui::SameLine();
  commandButton(env, "eraser", side);
  if (column) {
    const Column has = columnIn(env, cellsIn(env));
    if (has.settings) settingsCell(env);
    if (has.spine) spineButton(env, side, next);
  } else {
    ImGui::SameLine();
    if (settingsShown(env) > 0) {
      settings(env, showsAll(env));
      ImGui::SameLine();
    }
    line(env);
    spineButton(env, spineWidth(env), next);
  }
  endCard();
  openMenu(env, card);
}

}  // namespace spineloft::panels
