// What the tool in use can be told, in the upper right corner of its view: commands as buttons,
// with their words where there is room, and the sliders of a coil.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "web/commands/command_actions.h"
#include "web/commands/intents.h"
#include "web/edit/layers.h"
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

constexpr double kMargin = 8, kGap = kCellGap, kPadding = 4;
constexpr double kChipRoom = 84;    // of the view's name at its left
constexpr double kColumnRoom = 58;  // of the buttons at the side of a low view
constexpr double kBelow = 6;        // between two cards
constexpr double kLowSolid = 380;   // in which two rows of buttons leave no room for a solid
constexpr float kMostTurns = 8;

using Ids = std::span<const app::CommandId>;

Ids itemsOf(const PanelEnv& env) {
  const app::UiState& ui = env.ui();
  // The most used first: the last ones wait in a menu where there is no room.
  static constexpr app::CommandId kRibs[] = {"add-rib",    "delete-rib", "lock-rib",   "reset-rib",
                                             "reach-less", "reach-more", "fewer-ribs", "more-ribs"};
  static constexpr app::CommandId kShape[] = {"both-sides", "reset-ribs"};
  static constexpr app::CommandId kSpineLine[] = {"find-edges", "keep-ribs",  "side-view", "coil",
                                                  "join-ends",  "reset-pose", "make-round"};
  static constexpr app::CommandId kBones[] = {"slice-here", "toggle-bone", "reset-bones"};
  static constexpr app::CommandId kIgnore[] = {"brush-smaller", "brush-larger", "paint-over", "ignore-whole-picture",
                                               "clear-ignored"};
  static constexpr app::CommandId kDraw[] = {"depth-by-pressure"};
  static constexpr app::CommandId kPlace[] = {"drop-on-floor", "duplicate", "snap-to-surface", "face-front",
                                              "mirror-copy",   "symmetry",  "group",           "ungroup"};
  static constexpr app::CommandId kCut[] = {"cut-use", "cut-add",       "cut-remove",  "cut-cancel",
                                            "undo",    "brush-smaller", "brush-larger"};
  static constexpr app::CommandId kPuff[] = {"cut-by-box", "cut-by-scribble", "puff-both", "puff-front", "puff-back"};
  static constexpr app::CommandId kSheet[] = {"cut-by-box", "cut-by-scribble", "edge-sharp", "edge-bevel",
                                              "edge-round"};
  static constexpr app::CommandId kLayers[] = {"layer-up",   "layer-down", "layer-circle", "layer-square",
                                               "edit-slice", "layer-copy", "layer-face",   "layer-remove"};
  static constexpr app::CommandId kFirstLayer[] = {"paste-slices", "layer-circle", "layer-square", "edit-slice",
                                                   "layer-up",     "layer-down",   "layer-face"};
  static constexpr app::CommandId kLines[] = {"seen-pen", "hidden-pen"};
  static constexpr app::CommandId kPull[] = {"pull-out",   "pull-in",   "pull-narrower", "pull-wider",
                                             "pull-sharp", "pull-next", "pull-remove"};
  static constexpr app::CommandId kBridge[] = {"bridge-narrower", "bridge-wider"};
  static constexpr app::CommandId kHollow[] = {"hollow-use", "hollow-cancel", "hollow-next"};
  static constexpr app::CommandId kNew[] = {"in-front", "inside", "behind"};
  static constexpr app::CommandId kWays[] = {"draw", "puff", "sheet"};
  if (ui.solids.hollow) return kHollow;
  const bool draws =
      ui.tool == app::ToolKind::Draw || app::drawsRegions(ui.tool) || ui.tool == app::ToolKind::Primitive;
  if (draws && !ui.cut && !ui.preview && app::partIsNew(env.env)) return kNew;
  switch (ui.tool) {
    case app::ToolKind::Inflate:
      return ui.cut ? Ids(kCut) : kPuff;
    case app::ToolKind::Extrude:
      return ui.cut ? Ids(kCut) : kSheet;
    case app::ToolKind::Place:
      return kPlace;
    case app::ToolKind::Layers:
      return ui.sections.copied && !app::layersInHand(env.document(), ui) ? Ids(kFirstLayer) : kLayers;
    case app::ToolKind::Lines:
      return kLines;
    case app::ToolKind::Pull:
      return kPull;
    case app::ToolKind::Bridge:
      return kBridge;
    case app::ToolKind::Ribs:
      return kRibs;
    case app::ToolKind::Shape:
      return kShape;
    case app::ToolKind::Spine:
      return app::bonesInHand(env.document(), env.derived, ui) ? Ids(kBones) : kSpineLine;
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
  if (part == nullptr || !part->mirror || env.ui().tool != app::ToolKind::Place || env.ui().solids.hollow) return;
  const double width = std::min(300.0, env.ui().layout.solid.width - 2 * kMargin);
  constexpr double kHeight = 66, kApart = 6;
  const app::Rect& beside = env.ui().solidButtons;
  const double head = beside.width > 0 ? std::min(bar.y, beside.y) : bar.y;
  const double y = atFoot ? head - kApart - kHeight : bar.bottom() + kApart;
  const double left = std::max(env.ui().layout.solid.x + kMargin, bar.right() - width);
  const app::Rect card{left, y, width, kHeight};
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
  BarSplit bar;
  BarCells cells;
  bool words = true;  ///< below the icons
  float side = 0;     ///< height of a button
  int rows() const { return rowsOf(cells); }
  double height() const { return rows() * (static_cast<double>(side) + kGap) - kGap + 2 * kPadding; }
  double more() const { return bar.rest.empty() ? 0 : static_cast<double>(side) + kGap; }
};

/// `most`: commands in the bar, when one row has no room for all.
Split foldWith(const PanelEnv& env, Ids ids, bool words, std::size_t most, double room) {
  Split out;
  out.words = words;
  out.side = words ? wordedHeight(env) : buttonSide(env);
  const std::size_t cells = most < ids.size() ? most + 1 : ids.size();  // one is the menu's
  out.bar = splitBar(ids, cells, [&](app::CommandId id) { return isToolInUse(env, id); });
  out.cells = arrangeCells(env, out.bar.shown, words, room - out.more(), out.side);
  return out;
}

/// As many as one row has room for.
Split foldRow(const PanelEnv& env, Ids ids, bool words, double room) {
  std::size_t most = ids.size();
  Split out = foldWith(env, ids, words, most, room);
  while (out.rows() > 1 && most > 1) out = foldWith(env, ids, words, --most, room);
  return out;
}

/// One row where the view is small, else as many as are needed; with words, where the view has room for the rows, and
/// one row for the most used: then the others wait in the menu.
Split fold(const PanelEnv& env, Ids ids, bool oneRow, double room, double height) {
  constexpr double kMostOfView = 0.35;
  constexpr std::size_t kMostUsed = 4;
  const auto with = [&](bool words) {
    return oneRow ? foldRow(env, ids, words, room) : foldWith(env, ids, words, ids.size(), room);
  };
  const Split worded = with(true);
  const bool fits = height >= kWordsFrom && worded.height() <= kMostOfView * height &&
                    worded.bar.shown.size() >= std::min(kMostUsed, ids.size());
  return fits ? worded : with(false);
}

void paintBar(const PanelEnv& env, const app::Rect& card, const Split& split, ImU32 colour) {
  const BarCells& cells = split.cells;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {kPadding, kPadding});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {kGap, kGap});
  beginFixed("edit bar", card);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0 && cells[i].row == cells[i - 1].row) ImGui::SameLine();
    commandButton(env, cells[i].id, split.side, split.words ? static_cast<float>(cells[i].width) : 0, colour);
  }
  if (!split.bar.rest.empty()) {
    if (!cells.empty()) ImGui::SameLine();
    barMenuButton(env, app::BarMenu::Edit, split.side);
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
  if (height > 0) env.ui().barHead = height + kMargin;
  return height;
}

}  // namespace

void drawEditBar(const PanelEnv& env) {
  const Ids items = itemsOf(env);
  // What works in the solid view.
  const bool places = app::worksInSolid(env.ui().tool) || env.ui().solids.hollow;
  const app::Layout& layout = env.ui().layout;
  const app::Rect& view = places ? layout.solid : layout.picture;
  env.ui().barHead = 0;
  // The board for a section has the picture's place to itself; a layer is on it, and not on the sheet.
  const auto& board = env.ui().sections.board;
  const bool covered = board && (!places || board->sheet);
  if (covered || env.document().pictures.empty()) return;
  const double shapes = shapesAtHead(env);
  if (items.empty()) return;
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
  if (room < static_cast<double>(buttonSide(env))) return;
  const Split split = fold(env, items, layout.stacked || small || column > 0, room, view.height);
  const double width = widestRow(split.cells) + split.more() + 2 * kPadding;
  const double height = split.height();
  const double head = view.y + kMargin + (shapes > 0 ? shapes + kBelow : 0);
  const double y = atFoot ? view.bottom() - kMargin - height : head;
  const app::Rect card{view.right() - column - kMargin - width, y, width, height};
  env.ui().overlays.push_back(card);
  if (layout.stacked && !places && shapes == 0) env.ui().barHead = height + kMargin;
  const ImU32 colour = toolColour(env.ui().tool);
  paintBar(env, card, split, colour);
  barMenu(env, app::BarMenu::Edit, split.bar, card, colour);
  coilCard(env, card);
  sidesCard(env, card, atFoot);
  sheetCard(env, card, atFoot);
}

}  // namespace spineloft::panels
