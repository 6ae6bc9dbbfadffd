// Small things above the views: what each is, zoom and home buttons, the legend of the ribs, the
// bar between the views, progress.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "web/edit/editing.h"
#include "web/edit/line_drawing.h"
#include "web/edit/shaping.h"
#include "web/panels/bar_menu.h"
#include "web/panels/draw_lines.h"
#include "web/panels/picture_strip.h"
#include "web/panels/point_control.h"
#include "web/panels/short_list.h"
#include "web/panels/theme.h"
#include "web/panels/widgets.h"
#include "web/ui/sizing.h"

namespace spineloft::panels {
namespace {

constexpr double kMargin = 10;
constexpr double kFoot = 84;     // from a hint's middle to the foot of its view
constexpr double kClear = 6;     // between a hint and what is there
constexpr double kPenRoom = 58;  // what the card of the pen takes at the foot of a sketch

/// Buttons of a view and the menu of those that have no room.
struct Bar {
  app::BarMenu menu;
  const char* name;
  app::Rect view;
  std::span<const app::CommandId> ids;  ///< the most used first
  app::Focus focus;
  double taken = 0;  ///< of the view's width, from the left
};

/// With words, in few rows. None: the view is too low for them, or too narrow.
std::optional<BarCells> wordedCells(const PanelEnv& env, std::span<const app::CommandId> ids, double room,
                                    double height) {
  constexpr double kMostOfView = 0.25;
  if (ids.empty() || height < kWordsFrom) return std::nullopt;
  const BarCells cells = arrangeCells(env, ids, true, room, 0);
  const int rows = rowsOf(cells);
  const double tall = rows * (static_cast<double>(wordedHeight(env)) + kCellGap);
  return widestRow(cells) <= room && (rows == 1 || tall <= kMostOfView * height) ? std::optional(cells) : std::nullopt;
}

/// In the lower right corner, with words below the icons where all have room for them, else one row, or a column where
/// the view is low. Where it is; nowhere when there is no room at all.
app::Rect buttons(const PanelEnv& env, const Bar& bar) {
  const app::Rect& view = bar.view;
  const bool column = app::buttonsAtSide(view);
  const double edge = 6, room = (column ? view.height : view.width - bar.taken) - 2 * 4 - edge;
  const auto words = column ? std::nullopt : wordedCells(env, bar.ids, room, view.height);
  const float side = words ? wordedHeight(env) : env.ui().touch ? 44.f : 34.f;
  const double cell = static_cast<double>(side) + kCellGap;
  if (room < cell || bar.ids.empty()) return {};
  const std::size_t cells = words ? bar.ids.size() : static_cast<std::size_t>(room / cell);
  const BarSplit split = splitBar(bar.ids, cells, [&](app::CommandId id) { return isToolInUse(env, id); });
  const double length = (words ? widestRow(*words) + kCellGap : static_cast<double>(split.cells()) * cell) + edge;
  const double breadth = (words ? rowsOf(*words) : 1) * cell + edge;
  const double width = column ? breadth : length, height = column ? length : breadth;
  const double margin = std::min({kMargin, (view.height - height) / 2, (view.width - width) / 2});
  const app::Rect card{view.right() - width - margin, view.bottom() - height - margin, width, height};
  const bool emptyBefore = env.sink.empty();
  beginCard(env, bar.name, card);
  for (std::size_t i = 0; i < split.shown.size(); ++i) {
    const bool inRow = i > 0 && !column && !(words && (*words)[i].row != (*words)[i - 1].row);
    if (inRow) ImGui::SameLine();
    commandButton(env, split.shown[i], side, words ? commandButtonWidth(env, split.shown[i]) : 0);
  }
  if (!split.rest.empty()) {
    if (!split.shown.empty() && !column) ImGui::SameLine();
    barMenuButton(env, bar.menu, side);
  }
  endCard();
  barMenu(env, bar.menu, split, card, toolColour(env.ui().tool));
  if (emptyBefore && !env.sink.empty()) env.ui().focus = bar.focus;
  return card;
}

/// Words that lie above a view, in sight of whoever asks what the page shows.
void registerWords(const PanelEnv& env, std::string words, ImVec2 low, ImVec2 high) {
  env.ui().controls.push_back(
      {app::Control::Kind::Words, std::move(words), {low.x, low.y, high.x - low.x, high.y - low.y}});
}

void chip(const PanelEnv& env, const app::Rect& view, Text words, bool focused) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  ImFont* font = env.fonts.small;
  const std::string_view text = shortened(font, words, static_cast<float>(view.width - 2 * kMargin) - 20);
  const ImVec2 extent = extentOf(font, text);
  const ImVec2 at{static_cast<float>(view.x + kMargin), static_cast<float>(view.y + kMargin)};
  const ImVec2 end{at.x + extent.x + 20, at.y + extent.y + 10};
  list.AddRectFilled(at, end, faded(kSurface, 235), 20);
  list.AddRect(at, end, focused ? kAccent : kLine, 20, 0, 1.2f);
  drawLine(list, {font, {at.x + 10, at.y + 5}, focused ? kAccent : kMuted}, text);
  registerWords(env, std::string(words.words), at, end);
}

struct LegendEntry {
  ribs::RibState state;
  const char* text;
};
constexpr LegendEntry kLegend[] = {{ribs::RibState::Edge, words::text("on an edge")},
                                   {ribs::RibState::Bridged, words::text("bridged")},
                                   {ribs::RibState::Guessed, words::text("guessed")},
                                   {ribs::RibState::Edited, words::text("by hand")},
                                   {ribs::RibState::Locked, words::text("locked")}};

/// The states that the ribs in view have, in the order of the legend.
ShortList<LegendEntry> statesInView(const PanelEnv& env) {
  const app::UiState& ui = env.ui();
  const ribs::RibSet* set = nullptr;
  if (ui.preview && ui.preview->shape) {
    set = &ui.preview->shape->ribs;
  } else if (const auto subject = app::subjectOf(env.document(), env.derived, ui.selection)) {
    set = &subject.shape->ribs;
  }
  ShortList<LegendEntry> found;
  for (const LegendEntry& entry : kLegend) {
    const bool occurs = set && std::ranges::any_of(set->ribs, [&](const ribs::Rib& rib) {
                          return rib.leftState == entry.state || rib.rightState == entry.state;
                        });
    if (occurs) found.push_back(entry);
  }
  return found;
}

/// On a phone the legend would cover the picture: it comes and goes with a tap. True while it is open.
bool legendButton(const PanelEnv& env, const app::Rect& view) {
  const float side = buttonSide(env);
  const double width = static_cast<double>(side) + 8;
  beginCard(env, "legend", {view.right() - kMargin - width, view.y + kMargin, width, width});
  bool& open = env.ui().legendOpen;
  const char* tip = "What the colours of the ribs mean";
  if (iconButton(env, {"legend", "list", tip, open, true, side})) open = !open;
  endCard();
  return open;
}

/// Colour and line style of the rib ends, in the lower left corner of the picture view, above `bar`
/// where they would meet; on a phone below its button, while nothing else is there.
void legend(const PanelEnv& env, const app::Rect& view, const app::Rect& bar) {
  const ShortList<LegendEntry> entries = statesInView(env);
  const bool onPaper = app::shownSketch(env.document(), env.ui()) != nullptr;
  const bool stacked = env.ui().layout.stacked;
  const bool taken = stacked && (env.ui().barHead > 0 || app::buttonsAtSide(view));  // by other buttons
  if (entries.empty() || view.width < 330 || view.height < 200 || taken) return;
  if (stacked && !legendButton(env, view)) return;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  ImFont* font = env.fonts.small;
  const float size = font->FontSize * ImGui::GetIO().FontGlobalScale, line = size + 6;
  const float sample = stacked ? 14.f : 20.f;
  const auto widthOf = [&](const char* text) { return sample + 6 + extentOf(font, shown(text)).x + 12; };
  float width = 12, widest = 0;
  for (const LegendEntry& entry : entries) {
    width += widthOf(entry.text);
    widest = std::max(widest, widthOf(entry.text));
  }
  const bool tall = stacked || width > view.width - 2 * kMargin;
  const float height = tall ? line * static_cast<float>(entries.size()) + 8 : line + 8;
  if (tall) width = widest + 12;
  const double column = env.ui().barLeft, left = view.x + kMargin + column;
  double foot = view.bottom() - kMargin - (onPaper && column == 0 ? kPenRoom : 0);
  if (left + width + 6 > bar.x && bar.width > 0) foot = std::min(foot, bar.y - 6);
  const ImVec2 at = stacked ? ImVec2(static_cast<float>(view.right() - kMargin) - width,
                                     static_cast<float>(view.y + kMargin) + buttonSide(env) + 14)
                            : ImVec2(static_cast<float>(left), static_cast<float>(foot) - height);
  list.AddRectFilled(at, {at.x + width, at.y + height}, faded(kSurface, 235), kRadius);
  list.AddRect(at, {at.x + width, at.y + height}, kLine, kRadius);
  ImVec2 pen{at.x + 12, at.y + 4 + line / 2};
  std::string words;
  for (const LegendEntry& entry : entries) {
    Pen look = ribPen(entry.state);
    look.width += 0.8f;
    styledLine(list, pen, {pen.x + sample, pen.y}, look);
    drawLine(list, {font, {pen.x + sample + 6, pen.y - size / 2}, kMuted}, shown(entry.text));
    (tall ? pen.y : pen.x) += tall ? line : widthOf(entry.text);
    words += (words.empty() ? "" : ", ") + std::string(entry.text);
  }
  registerWords(env, std::move(words), at, {at.x + width, at.y + height});
}

void splitter(const app::Layout& layout) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const app::Rect& bar = layout.splitter;
  const ImVec2 at{static_cast<float>(bar.x), static_cast<float>(bar.y)};
  const ImVec2 end{static_cast<float>(bar.right()), static_cast<float>(bar.bottom())};
  list.AddRectFilled(at, end, kTrough);
  const ImVec2 c{(at.x + end.x) / 2, (at.y + end.y) / 2};
  const ImVec2 half = layout.stacked ? ImVec2(18, 1.6f) : ImVec2(1.6f, 18);
  list.AddRectFilled({c.x - half.x, c.y - half.y}, {c.x + half.x, c.y + half.y}, kHandle, 2);
}

struct Pill {
  const char* text = "";
  ImU32 fill = 0, ink = 0;
};

/// A line or two of text with round ends, centred in `view` at the height `y`, or towards its head or foot where
/// something else is; nothing where there is no room.
void pill(const PanelEnv& env, const app::Rect& view, double y, app::Toward way, const Pill& what) {
  ImGui::PushFont(env.fonts.text);
  const auto lines =
      inTwoLines(env.fonts.text, what.text, static_cast<float>(view.width) - 28 - 2 * static_cast<float>(kClear));
  const ImVec2 first = extentOf(env.fonts.text, lines[0]),
               second = lines[1].empty() ? ImVec2{} : extentOf(env.fonts.text, lines[1]);
  const ImVec2 extent{std::max(first.x, second.x), lines[1].empty() ? first.y : first.y + second.y};
  std::vector<app::Rect> taken = env.ui().overlays;
  for (const app::Control& control : env.ui().controls) {
    if (control.kind == app::Control::Kind::Words) taken.push_back(control.at);
  }
  const double width = extent.x + 28., height = extent.y + 14.;
  const app::Rect wanted{std::round(view.centre().x - width / 2), std::round(y - height / 2), width, height};
  const app::Rect at = app::clearOf(wanted, taken, kClear, way);
  if (at.y >= view.y && at.bottom() <= view.bottom()) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImVec2 low{static_cast<float>(at.x), static_cast<float>(at.y)};
    const ImVec2 high{static_cast<float>(at.right()), static_cast<float>(at.bottom())};
    list.AddRectFilled(low, high, what.fill, 20);
    const float middle = (low.x + high.x) / 2;
    drawLine(list, {env.fonts.text, {middle - first.x / 2, low.y + 7}, what.ink}, lines[0]);
    if (!lines[1].empty()) {
      drawLine(list, {env.fonts.text, {middle - second.x / 2, low.y + 7 + first.y}, what.ink}, lines[1]);
    }
    registerWords(env, what.text, low, high);
  }
  ImGui::PopFont();
}

/// In a lower view a pill would cover what it is about; the status line says it, too.
constexpr double kPillRoom = 200, kShapeRoom = 300;

/// Of the tool Shapes.
const char* shapeHint(const PanelEnv& env) {
  const document::Part* part = env.selected();
  const document::ShapeRecipe* shape = part ? document::shapeOf(*part) : nullptr;
  if (const document::Part* aside = app::partAside(env.document(), env.ui())) {
    return *document::sideOf(aside->recipe) ? "" : "Draw round the part as it is seen here";
  }
  if (shape == nullptr) return "Drag the shape from one end to the other, or tap a thing";
  const auto view = document::viewOn(env.document(), env.ui().picture, shape->picture);
  if (!view.ok()) return "Say above from where this picture looks";
  const bool drawn = std::ranges::count(shape->outlines, env.ui().picture, &document::Outline::picture) > 0;
  return drawn ? "" : view.value() ? "Draw round the shape as it is seen here" : "Draw along its edge to change it";
}

/// Of the tool Lines.
const char* lineHint(const PanelEnv& env) {
  if (!env.ui().inHand.stroke.empty()) return "";
  const app::LineMarks marks = app::lineMarks(env.document(), env.derived, env.ui());
  if (!marks.looseEnds.empty()) return "Draw on from a ring, or tap it to close the line";
  if (env.document().drawings.empty()) return "Draw a closed line: it becomes a piece";
  return marks.crossings.empty() ? "Draw one more piece. What ends at an edge goes on behind it"
                                 : "Tap a crossing to swap front and back there";
}

/// What one may do in the picture next, of what the tool in use is for; empty: it is known.
const char* hintFor(const PanelEnv& env) {
  const app::Rect& view = env.ui().layout.picture;
  if (view.height < kPillRoom) return "";
  const bool drawing = static_cast<bool>(env.ui().preview);
  if (env.ui().cut && !env.ui().cut->shape.contours.empty()) {
    return env.ui().cut->adding ? "Draw over what is missing" : "Draw over what is too much";
  }
  const document::Part* part = env.selected();
  const app::ToolKind tool = env.ui().tool;
  const bool regionTool = app::drawsRegions(tool) && !env.ui().cut;
  if (tool == app::ToolKind::Spin && !part && !drawing) return "Draw one side of a thing beside the dashed line";
  const bool told = env.ui().pointsKnown || env.ui().redraw || drawing;
  if (regionTool && !told && part && document::regionOf(part->recipe)) return "Tap the part to change its outline";
  if (tool == app::ToolKind::Primitive && !drawing && !env.ui().cut && view.height > kShapeRoom) return shapeHint(env);
  if (tool == app::ToolKind::Lines && view.height > kShapeRoom) return lineHint(env);
  const bool rib = tool == app::ToolKind::Ribs || tool == app::ToolKind::Shape;
  const bool posed = rib && part && !document::loftIn(*part).pose.isRest();
  return posed && view.height > 300 ? "Ribs are changed where they were drawn" : "";
}

}  // namespace

// What to do first, the shell says.
void drawHints(const PanelEnv& env) {
  const app::Layout& layout = env.ui().layout;
  const app::Rect& view = layout.picture;
  const bool drawing = static_cast<bool>(env.ui().preview);
  if (env.document().pictures.empty() || env.ui().sections.board) return;
  if (env.ui().redraw && !drawing) {
    pill(env, view, view.y + 26, app::Toward::Foot, {"Draw the new line", kAccent, kOnAccent});
  }
  const char* hint = hintFor(env);
  if (*hint != 0) pill(env, view, view.bottom() - kFoot, app::Toward::Head, {hint, faded(kSurface, 235), kMuted});
  if (env.ui().preview && env.ui().preview->crossing) {
    pill(env, layout.solid, layout.solid.bottom() - kFoot, app::Toward::Head,
         {"Any further, and it would go through itself", kAccent, kOnAccent});
  }
  if (env.ui().solids.hollow) {
    pill(env, layout.solid, layout.solid.bottom() - kFoot, app::Toward::Head,
         {"Tap where it is to open", kAccent, kOnAccent});
  }
  const bool layers = env.ui().tool == app::ToolKind::Layers;
  if (layers && !layout.stacked && env.document().parts.empty() && !drawing) {
    pill(env, layout.solid, layout.solid.bottom() - kFoot, app::Toward::Head,
         {"Draw a closed line on the sheet", kAccent, kOnAccent});
  }
  const document::Part* pulled = env.ui().tool == app::ToolKind::Pull ? env.selected() : nullptr;
  const bool draws = !env.ui().inHand.onSolid.empty() || !env.ui().inHand.besideSolid.empty();
  if (pulled != nullptr && pulled->pulls.empty() && !draws && !env.ui().solids.hollow) {
    pill(env, layout.solid, layout.solid.bottom() - kFoot, app::Toward::Head,
         {"Tap the solid, or draw a line or a ring on it", kAccent, kOnAccent});
  }
  const bool bridges = env.ui().tool == app::ToolKind::Bridge && env.ui().inHand.besideSolid.empty();
  if (bridges && (env.selected() == nullptr || document::bridgeOf(*env.selected()) == nullptr)) {
    pill(env, layout.solid, layout.solid.bottom() - kFoot, app::Toward::Head,
         {"Drag from one place of the solid to another", kAccent, kOnAccent});
  }
  // What is to come, while there is nothing to see yet.
  if (env.document().parts.empty() && !drawing && !layers) {
    pill(env, layout.solid, layout.solid.centre().y, app::Toward::Foot,
         {"Your solid appears here", faded(kSurface, 0), kMuted});
  }
}

void drawViewChrome(const PanelEnv& env) {
  const app::Layout& layout = env.ui().layout;
  if (env.document().pictures.empty()) return;
  if (env.ui().sections.board) {  // the board is in the picture's place
    chip(env, layout.solid, "Solid", true);
    return;
  }
  splitter(layout);
  const bool onPicture = env.ui().focus == app::Focus::Picture;
  const app::ToolKind tool = env.ui().tool;
  const bool plain = tool == app::ToolKind::Draw || tool == app::ToolKind::Hand || app::worksInSolid(tool);
  const double shift = env.ui().barLeft;
  const app::Rect beside{layout.picture.x + shift, layout.picture.y, layout.picture.width - shift,
                         layout.picture.height};
  if (plain || !layout.stacked) chip(env, beside, "Picture", onPicture);
  const bool barInSolid = app::worksInSolid(tool) && !env.ui().solids.hollow;
  const std::string size = app::roundLength(env.document().height.value);
  const bool sharesRow = barInSolid && !layout.stacked;
  const Text solid = env.document().parts.empty() || sharesRow
                         ? Text("Solid")
                         : asIs(words::tr("Solid, {size} tall", {{"size", size}}));
  chip(env, layout.solid, solid, !onPicture);
  // The most used first. Fingers pinch: they need no zoom buttons.
  constexpr app::CommandId kFirst[] = {"draw", "puff", "sheet", "shapes", "lines", "spin", "layers", "hand", "fit"};
  constexpr app::CommandId kSimpleFew[] = {"draw", "puff", "sheet", "fit", "more-tools"};
  constexpr app::CommandId kSimple[] = {"draw", "puff", "sheet", "more-tools", "fit", "zoom-out", "zoom-in"};
  constexpr app::CommandId kPictureFew[] = {"draw",  "puff",         "ribs",  "bone", "sheet",
                                            "shape", "shapes",       "lines", "spin", "layers",
                                            "hand",  "ignore-edges", "fit",   "pull", "bridge"};
  constexpr app::CommandId kPictureAll[] = {"draw", "puff",         "sheet", "shapes",   "lines",
                                            "spin", "layers",       "hand",  "ribs",     "shape",
                                            "bone", "ignore-edges", "fit",   "zoom-out", "zoom-in"};
  constexpr app::CommandId kSolidFew[] = {"pull", "bridge", "move", "home-view"};
  constexpr app::CommandId kSolidAll[] = {"pull", "bridge", "move", "zoom-out", "zoom-in", "home-view"};
  using Ids = std::span<const app::CommandId>;
  const bool few = layout.stacked || env.ui().touch || layout.picture.width < 330 || app::buttonsAtSide(layout.picture);
  // Few buttons at first: what changes a part comes with the first part.
  const bool empty = env.document().parts.empty();
  const app::Rect paper = sketchBarRect(env);
  const bool onPaper = app::shownSketch(env.document(), env.ui()) != nullptr;
  const Ids simple = few ? Ids(kSimpleFew) : Ids(kSimple);
  constexpr std::size_t kLocal = 2;  // pull and bridge
  // In a narrow view the solid's own buttons leave no room for them.
  const bool pullAside = few && layout.solid.width < 330;
  const Ids changing =
      few ? Ids(kPictureFew).first(std::size(kPictureFew) - (pullAside ? 0 : kLocal)) : Ids(kPictureAll);
  const Ids full = (few || onPaper) && empty ? Ids(kFirst) : changing;
  const Ids all = env.ui().allTools ? full : simple;
  const Ids ids = all.subspan(onPaper ? 1 : 0);  // the card of the pen has the spine
  const double taken = paper.width > 0 ? paper.right() - layout.picture.x : 0;
  const app::Rect bar =
      buttons(env, {app::BarMenu::Picture, "picture buttons", layout.picture, ids, app::Focus::Picture, taken});
  constexpr double kGap = 8;  // between a picture and its buttons
  env.ui().barFoot = bar.width > 0 && !app::buttonsAtSide(layout.picture) ? layout.picture.bottom() - bar.y + kGap : 0;
  legend(env, layout.picture, bar);
  const bool fewSolid =
      layout.stacked || env.ui().touch || layout.solid.width < 200 || app::buttonsAtSide(layout.solid);
  env.ui().solidButtons = {};
  if (env.ui().solids.hollow) return;  // its bar is in their place
  const Ids onSolid =
      Ids(fewSolid ? Ids(kSolidFew) : Ids(kSolidAll)).subspan(env.ui().allTools && !empty && !pullAside ? 0 : kLocal);
  env.ui().solidButtons =
      buttons(env, {app::BarMenu::Solid, "solid buttons", layout.solid, onSolid, app::Focus::Solid});
}

void draw(const PanelEnv& env) {
  env.ui().overlays.clear();
  env.ui().controls.clear();
  env.ui().rows.clear();
  env.ui().sections.graphs.clear();
  drawPictureOverlay(env);
  drawPictureStrip(env);
  drawSectionOverlay(env);
  drawSolidOverlay(env);
  tellHandles(env);
  drawScale(env);
  drawFailureInSolid(env);
  drawHollowOverlay(env);
  drawViewChrome(env);
  drawSketchBar(env);
  drawEditBar(env);
  drawPlaceOverlay(env);
  drawHints(env);
  env.ui().solidRoom = app::roomBeside(env.ui().layout.solid, env.ui().overlays);
  drawSidePanel(env);
  drawSectionBoard(env);
}

}  // namespace spineloft::panels
