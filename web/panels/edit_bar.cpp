// What the tool in use can be told, in the upper right corner of its view: commands as buttons,
// with their words where there is room, and the sliders of a coil.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "web/commands/command_actions.h"
#include "web/commands/intents.h"
#include "web/edit/placing.h"
#include "web/edit/preview.h"
#include "web/edit/puff_bones.h"
#include "web/panels/bar_menu.h"
#include "web/panels/number_text.h"
#include "web/panels/theme.h"
#include "web/panels/widgets.h"
#include "web/words/words.h"

namespace spineloft::panels {
namespace {

constexpr double kMargin = 8, kGap = 2, kPadding = 4;
constexpr double kChipRoom = 84;    // of the view's name at its left
constexpr double kColumnRoom = 58;  // of the buttons at the side of a low view
constexpr double kBelow = 6;        // between two cards
constexpr double kLowSolid = 380;   // in which two rows of buttons leave no room for a solid
constexpr float kMostTurns = 8;

struct Item {
  app::CommandId id;
  bool words = false;  ///< says what it does where there is room
};

std::span<const Item> itemsOf(const PanelEnv& env) {
  const app::UiState& ui = env.ui();
  // The most used first: the last ones wait in a menu where there is no room.
  static constexpr Item kRibs[] = {{"add-rib", true}, {"delete-rib", true}, {"lock-rib", true}, {"reset-rib"},
                                   {"reach-less"},    {"reach-more"},       {"fewer-ribs"},     {"more-ribs"}};
  static constexpr Item kShape[] = {{"both-sides", true}, {"reset-ribs", true}};
  static constexpr Item kSpineLine[] = {{"find-edges", true}, {"keep-ribs", true},  {"side-view", true}, {"coil", true},
                                        {"join-ends", true},  {"reset-pose", true}, {"make-round", true}};
  static constexpr Item kBones[] = {{"slice-here", true}, {"toggle-bone", true}, {"reset-bones", true}};
  static constexpr Item kIgnore[] = {{"brush-smaller"},
                                     {"brush-larger"},
                                     {"paint-over", true},
                                     {"ignore-whole-picture", true},
                                     {"clear-ignored", true}};
  static constexpr Item kDraw[] = {{"depth-by-pressure", true}};
  static constexpr Item kPlace[] = {{"drop-on-floor", true}, {"duplicate", true}, {"snap-to-surface", true},
                                    {"face-front", true},    {"mirror-copy"},     {"symmetry", true},
                                    {"group", true},         {"ungroup"}};
  static constexpr Item kCut[] = {{"cut-use", true}, {"cut-add", true}, {"cut-remove", true}, {"cut-cancel", true},
                                  {"undo"},          {"brush-smaller"}, {"brush-larger"}};
  static constexpr Item kPuff[] = {
      {"cut-by-box", true}, {"cut-by-scribble", true}, {"puff-both", true}, {"puff-front", true}, {"puff-back", true}};
  static constexpr Item kSheet[] = {{"cut-by-box", true},
                                    {"cut-by-scribble", true},
                                    {"edge-sharp", true},
                                    {"edge-bevel", true},
                                    {"edge-round", true}};
  static constexpr Item kLayers[] = {{"layer-up", true},     {"layer-down", true}, {"layer-circle", true},
                                     {"layer-square", true}, {"layer-copy", true}, {"layer-face"},
                                     {"layer-remove"}};
  static constexpr Item kLines[] = {{"seen-pen", true}, {"hidden-pen", true}};
  static constexpr Item kHollow[] = {{"hollow-use", true}, {"hollow-cancel", true}, {"hollow-next", true}};
  static constexpr Item kNew[] = {{"in-front", true}, {"inside", true}, {"behind", true}};
  static constexpr Item kWays[] = {{"draw", true}, {"puff", true}, {"sheet", true}};
  if (ui.solids.hollow) return kHollow;
  const bool draws =
      ui.tool == app::ToolKind::Draw || app::drawsRegions(ui.tool) || ui.tool == app::ToolKind::Primitive;
  if (draws && !ui.cut && !ui.preview && app::partIsNew(env.env)) return kNew;
  switch (ui.tool) {
    case app::ToolKind::Inflate:
      return ui.cut ? std::span<const Item>(kCut) : kPuff;
    case app::ToolKind::Extrude:
      return ui.cut ? std::span<const Item>(kCut) : kSheet;
    case app::ToolKind::Place:
      return kPlace;
    case app::ToolKind::Layers:
      return kLayers;
    case app::ToolKind::Lines:
      return kLines;
    case app::ToolKind::Ribs:
      return kRibs;
    case app::ToolKind::Shape:
      return kShape;
    case app::ToolKind::Spine:
      return app::bonesInHand(env.document(), env.derived, ui) ? std::span<const Item>(kBones) : kSpineLine;
    case app::ToolKind::Ignore:
      return kIgnore;
    case app::ToolKind::Draw:
      if (const document::PictureEntry* paper = app::shownSketch(env.document(), ui)) {
        // What the outline becomes is chosen where it was drawn.
        if (env.document().parts.empty() && app::looksFinished(*paper)) return kWays;
      }
      if (ui.penSeen) return kDraw;
      return {};
    default:
      return {};
  }
}

struct Cell {
  Item item;
  double width = 0;
  int row = 0;
};
using Cells = ShortList<Cell>;

/// Puts cells into as few rows as `room` allows; how many those are.
int breakRows(Cells& cells, double room) {
  double x = 0;
  int row = 0;
  for (Cell& cell : cells) {
    if (x > 0 && x + cell.width > room) {
      x = 0;
      ++row;
    }
    cell.row = row;
    x += cell.width + kGap;
  }
  return row + 1;
}

/// Cells in rows of about the same width, none wider than `room`; the first ones get their words as far as one row
/// allows.
Cells arrange(const PanelEnv& env, std::span<const Item> items, double room, float side) {
  Cells cells;
  double width = 0;
  for (const Item& item : items) {
    cells.push_back({item, side, 0});
    width += side + kGap;
  }
  for (Cell& cell : cells) {
    if (!cell.item.words) continue;
    const double own = wordButtonWidth(env, app::commandOf(cell.item.id).label, side);
    if (width + own - side > room) continue;
    cell.width = own;
    width += own - side;
  }
  const int rows = breakRows(cells, room);
  if (rows == 1) return cells;
  // No row of a single button below a full one.
  double narrow = width / rows;
  while (narrow < room && breakRows(cells, narrow) > rows) narrow += kGap;
  breakRows(cells, std::min(narrow, room));
  return cells;
}

/// A slider that shows what it would do and does it when it is let go.
void coilSlider(const PanelEnv& env, const document::Part& part, bool turns, float width) {
  const app::Preview* held = env.ui().preview && env.ui().preview->part == part.id ? &*env.ui().preview : nullptr;
  loft::Pose pose = held ? held->loft().pose : document::loftIn(part).pose;
  double& own = turns ? pose.coilTurns : pose.coilRadius;
  const document::PictureEntry* entry = document::findPicture(env.document(), document::pictureOf(part));
  const int size = entry ? std::max(entry->size.width, entry->size.height) : 100;
  auto value = static_cast<float>(own);
  ImGui::SetNextItemWidth(width);
  // Pixels of the picture as lengths of the model.
  const double mm = static_cast<double>(value) / size * app::mmPerUnit(env.document(), env.derived);
  const auto tenths = [](double number) { return std::round(number * 10) / 10; };
  const std::string shown = turns ? numberText("{n} turns", own, 1) : numberText("{n} mm wide", mm, 1);
  const SliderTurn turn =
      turns ? slider(env, {"##turns", "Turns", -kMostTurns, kMostTurns, shown.c_str()}, value)
            : slider(env, {"##radius", "Width", 0, 0.25f * static_cast<float>(size), shown.c_str()}, value);
  // The slider reports a change in every frame while its value is between two tenths.
  const double wanted = turns ? tenths(static_cast<double>(value)) : static_cast<double>(value);
  if (turn.changed && wanted != own) {
    own = wanted;
    app::Preview& preview = app::previewPart(env.ui(), part);
    preview.asLoft().pose = pose;
    preview.fresh = false;
    app::guardPreview(env.ui(), env.document(), env.derived);
  }
  if (!turn.done) return;
  if (const document::LoftRecipe* taken = app::heldBack(env.ui())) pose = taken->pose;
  env.ui().preview.reset();
  env.sink.run(app::setCoil, part.id, pose.coilTurns, pose.coilRadius);
}

/// The card below the buttons.
void coilCard(const PanelEnv& env, const app::Rect& above) {
  const document::Part* part = env.selected();
  if (part == nullptr || env.ui().tool != app::ToolKind::Spine) return;
  const bool coils =
      document::loftIn(*part).pose.coilTurns != 0 || (env.ui().preview && env.ui().preview->loft().pose.coilTurns != 0);
  if (!coils) return;
  const double width = std::min(320.0, env.ui().layout.picture.width - 2 * kMargin);
  const app::Rect card{above.right() - width, above.bottom() + 6, width, 44};
  env.ui().overlays.push_back(card);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {8, 6});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushFont(env.fonts.small);
  beginFixed("coil", card);
  const float each = (static_cast<float>(width) - 22) / 2;
  coilSlider(env, *part, true, each);
  ImGui::SameLine();
  coilSlider(env, *part, false, each);
  ImGui::End();
  ImGui::PopFont();
  ImGui::PopStyleVar(2);
}

/// The ways in which the parts in hand have another side, as small pictures: below the buttons, or above those at the
/// foot, while they have one.
void sidesCard(const PanelEnv& env, const app::Rect& bar, bool atFoot) {
  const document::Part* part = env.selected();
  if (part == nullptr || !part->mirror || env.ui().tool != app::ToolKind::Place) return;
  const double width = std::min(300.0, env.ui().layout.solid.width - 2 * kMargin);
  constexpr double kHeight = 66, kApart = 6;
  const double y = atFoot ? bar.y - kApart - kHeight : bar.bottom() + kApart;
  const app::Rect card{bar.right() - width, y, width, kHeight};
  env.ui().overlays.push_back(card);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {kPadding, kPadding});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  beginFixed("sides", card);
  sidesTiles(env, *part->mirror, static_cast<float>(width) - 2 * static_cast<float>(kPadding));
  ImGui::End();
  ImGui::PopStyleVar(2);
}

/// What stands in the bar, and what in its menu.
struct Split {
  ShortList<Item> shown;
  BarSplit bar;
  double more(float side) const { return bar.rest.empty() ? 0 : side + kGap; }
};

/// One row where the view is small, else as many as are needed.
Split fold(const PanelEnv& env, std::span<const Item> items, bool small, double room, float side) {
  ShortList<app::CommandId> ids;
  for (const Item& item : items) ids.push_back(item.id);
  const double cells = small ? (room + kGap) / (side + kGap) : static_cast<double>(ids.size());
  Split out;
  out.bar = splitBar(ids, static_cast<std::size_t>(cells), [&](app::CommandId id) { return isToolInUse(env, id); });
  for (const app::CommandId id : out.bar.shown) out.shown.push_back(*std::ranges::find(items, id, &Item::id));
  return out;
}

void paintBar(const PanelEnv& env, const app::Rect& card, const Cells& cells, const Split& split, ImU32 colour) {
  const float side = buttonSide(env);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {kPadding, kPadding});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {kGap, kGap});
  beginFixed("edit bar", card);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0 && cells[i].row == cells[i - 1].row) ImGui::SameLine();
    wordButton(env, {cells[i].item.id, static_cast<float>(cells[i].width), side, colour});
  }
  if (!split.bar.rest.empty()) {
    if (!cells.empty()) ImGui::SameLine();
    barMenuButton(env, app::BarMenu::Edit, side);
  }
  ImGui::End();
  ImGui::PopStyleVar(3);
}

/// The card of the tool Shapes; how high it is. What else the bar holds comes and goes below it.
double shapesAtHead(const PanelEnv& env) {
  const app::Layout& layout = env.ui().layout;
  const app::Rect& view = layout.picture;
  const double chip = layout.stacked ? 0 : kChipRoom, column = app::buttonsAtSide(view) ? kColumnRoom : 0;
  const double height = shapeCard(env, {view.x + chip + kMargin, view.y + kMargin,
                                        view.width - chip - column - 2 * kMargin, view.height - 2 * kMargin});
  if (layout.stacked && height > 0) env.ui().barHead = height + kMargin;
  return height;
}

}  // namespace

void drawEditBar(const PanelEnv& env) {
  const std::span<const Item> items = itemsOf(env);
  // What works in the solid view.
  const bool places = app::worksInSolid(env.ui().tool) || env.ui().solids.hollow;
  const app::Layout& layout = env.ui().layout;
  const app::Rect& view = places ? layout.solid : layout.picture;
  env.ui().barHead = 0;
  // The board for a section has the picture's place to itself.
  const bool covered = !places && env.ui().sections.board;
  if (covered || env.document().pictures.empty()) return;
  const double shapes = shapesAtHead(env);
  if (items.empty()) return;
  const float side = buttonSide(env);
  // What is scooped out mostly opens at the head, where its arrow is: its bar is at the foot. On a phone, upright or on
  // its side, all that works in the solid view is there, beside the view's buttons: one row lies over the solid.
  const bool small = places && (layout.stacked || view.height < kLowSolid);
  const bool atFoot = env.ui().solids.hollow || small;
  // The view's name is at the head, and gives way on a phone; a column of buttons does not.
  const double chip = layout.stacked || atFoot ? 0 : kChipRoom;
  const app::Rect& beside = env.ui().solidButtons;
  const bool sharesFoot = small && beside.width > 0;
  const double column = app::buttonsAtSide(view) ? kColumnRoom : sharesFoot ? view.right() - beside.x : 0;
  const double room = view.width - chip - column - 2 * (kMargin + kPadding);
  if (room < side) return;
  const Split split = fold(env, items, layout.stacked || small || column > 0, room, side);
  const Cells cells = arrange(env, split.shown, room - split.more(side), side);
  const int rows = cells.empty() ? 1 : cells.back().row + 1;
  double widest = 0;
  for (int row = 0; row < rows; ++row) {
    double width = -kGap;
    for (const Cell& cell : cells) width += cell.row == row ? cell.width + kGap : 0;
    widest = std::max(widest, width);
  }
  const double width = widest + split.more(side) + 2 * kPadding;
  const double height = rows * (side + kGap) - kGap + 2 * kPadding;
  const double head = view.y + kMargin + (shapes > 0 ? shapes + kBelow : 0);
  const double y = atFoot ? view.bottom() - kMargin - height : head;
  const app::Rect card{view.right() - column - kMargin - width, y, width, height};
  env.ui().overlays.push_back(card);
  if (layout.stacked && !places && shapes == 0) env.ui().barHead = height + kMargin;
  const ImU32 colour = toolColour(env.ui().tool);
  paintBar(env, card, cells, split, colour);
  barMenu(env, app::BarMenu::Edit, split.bar, card, colour);
  coilCard(env, card);
  sidesCard(env, card, atFoot);
  sheetCard(env, card, atFoot);
}

}  // namespace spineloft::panels
