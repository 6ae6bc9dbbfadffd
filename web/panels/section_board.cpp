// The board on which a section is drawn: tools above, the square, and sections to start from below.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "web/commands/intents.h"
#include "web/edit/section_editing.h"
#include "web/panels/bar_menu.h"
#include "web/panels/draw_lines.h"
#include "web/panels/point_control.h"
#include "web/panels/section_paint.h"
#include "web/panels/theme.h"
#include "web/panels/widgets.h"

namespace spineloft::panels {
namespace {

constexpr ImU32 kWrong = rgb(0xc8102e);
constexpr float kStartTile = 46;

/// Buttons in rows that break where the room ends.
class Flow {
 public:
  explicit Flow(float width) : width_(width) {}
  void next(float width, float gap = 2) {
    if (used_ > 0 && used_ + gap + width <= width_) {
      ImGui::SameLine(0, gap);
      used_ += gap + width;
    } else {
      used_ = width;
    }
  }

 private:
  float width_, used_ = 0;
};

void toolButtons(const PanelEnv& env, Flow& flow, float side) {
  struct Entry {
    app::BoardTool tool;
    const char* icon;
    const char* tip;
  };
  constexpr std::array kTools = {
      Entry{app::BoardTool::Pen, "pencil", "Draw with the pen"},
      Entry{app::BoardTool::Line, "waypoints", "Straight lines: tap corner after corner"},
      Entry{app::BoardTool::Box, "square", "Drag a box"}, Entry{app::BoardTool::Ellipse, "circle", "Drag an ellipse"},
      Entry{app::BoardTool::Points, "mouse-pointer-2", "Drag points; tap the line for a new one"}};
  for (const Entry& entry : kTools) {
    flow.next(side);
    const bool on = env.ui().sections.board->tool == entry.tool;
    if (iconButton(env, {entry.icon, entry.icon, entry.tip, on, true, side})) {
      env.sink.run(app::useBoardTool, entry.tool);
    }
  }
}

/// Each press takes the next number of the wheel.
void foldButton(const PanelEnv& env, Flow& flow, float side) {
  const int fold = env.ui().sections.board->symmetry.fold;
  flow.next(side);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  commandButton(env, "slice-symmetry", side);
  if (fold <= 1) return;
  const char text[] = {static_cast<char>('0' + fold), '\0'};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 badge{at.x + side - 9, at.y + side - 10}, extent = extentOf(env.fonts.small, text);
  list.AddCircleFilled(badge, 9, kAccent, 16);
  drawLine(list, {env.fonts.small, {badge.x - extent.x / 2, badge.y - extent.y / 2}, kOnAccent}, text);
}

void divider(Flow& flow, float side) {
  flow.next(9);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddLine({at.x + 4, at.y + 6}, {at.x + 4, at.y + side - 6}, kLine, 1);
  ImGui::Dummy({9, side});
}

/// On a phone: the tools in one row, all else in a menu. (Undo and redo are in the row above.)
void smallToolbar(const PanelEnv& env, float width) {
  constexpr app::CommandId kMore[] = {"slice-corner",     "slice-remove-point", "slice-left-right",
                                      "slice-front-back", "slice-symmetry",     "slice-flip",
                                      "slice-turn",       "slice-traces",       "slice-clear"};
  const float side = buttonSide(env);
  const bool points = env.ui().sections.board->tool == app::BoardTool::Points;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  Flow flow(width);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {2, 2});
  toolButtons(env, flow, side);
  const auto room =
      static_cast<std::size_t>(std::max(1.f, (width + 2) / (side + 2) - static_cast<float>(app::BoardTool::kCount)));
  const BarSplit split = splitBar(std::span(kMore).subspan(points ? 0 : 2), room, [](app::CommandId) { return false; });
  for (const app::CommandId id : split.shown) {
    flow.next(side);
    commandButton(env, id, side);
  }
  if (!split.rest.empty()) {
    flow.next(side);
    barMenuButton(env, app::BarMenu::Board, side);
  }
  ImGui::PopStyleVar();
  barMenu(env, app::BarMenu::Board, split, {at.x, at.y, width, side}, kAccent);
}

void toolbar(const PanelEnv& env, float width) {
  if (env.ui().layout.stacked) return smallToolbar(env, width);
  const float side = buttonSide(env) - (env.ui().touch ? 0.f : 2.f);
  Flow flow(width);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {2, 2});
  const auto button = [&](app::CommandId id) {
    flow.next(side);
    commandButton(env, id, side);
  };
  toolButtons(env, flow, side);
  divider(flow, side);
  button("slice-left-right");
  button("slice-front-back");
  foldButton(env, flow, side);
  divider(flow, side);
  button("slice-undo");
  button("slice-redo");
  button("slice-flip");
  button("slice-turn");
  if (env.ui().sections.board->tool == app::BoardTool::Points) {
    button("slice-corner");
    button("slice-remove-point");
  }
  button("slice-traces");
  button("slice-clear");
  ImGui::PopStyleVar();
}

/// Rib, sides and mirrors: what lies below the drawing.
void paintGround(const PanelEnv& env, ImDrawList& list, const SectionFrame& frame) {
  const app::SectionBoard& board = *env.ui().sections.board;
  list.AddRectFilled(frame.at({-1, 1}), frame.at({1, -1}), kSurface, 4);
  for (const double v : {-0.5, 0.5}) {
    list.AddLine(frame.at({-1, v}), frame.at({1, v}), kHover);
    list.AddLine(frame.at({v, -1}), frame.at({v, 1}), kHover);
  }
  list.AddRect(frame.at({-1, 1}), frame.at({1, -1}), kLine, 4);
  if (!board.sheet) {
    styledLine(list, frame.at({-1, 0}), frame.at({1, 0}), {kEdgeRib, 1.6f, LineStyle::Solid});
    for (const double x : {-1.0, 1.0}) list.AddCircleFilled(frame.at({x, 0}), 4, kEdgeRib, 16);
  }
  const Pen mirror{kSpine, 1.2f, LineStyle::Dashed};
  if (board.symmetry.leftRight) styledLine(list, frame.at({0, -1.03}), frame.at({0, 1.03}), mirror);
  if (board.symmetry.frontBack) styledLine(list, frame.at({-1.03, 0}), frame.at({1.03, 0}), mirror);
  for (int k = 0; board.symmetry.fold > 1 && k < board.symmetry.fold; ++k) {
    const double angle = 2 * 3.14159265358979 * k / board.symmetry.fold + 1.5707963;
    styledLine(list, frame.at({0, 0}), frame.at({1.03 * std::cos(angle), 1.03 * std::sin(angle)}), mirror);
  }
  if (board.sheet && !board.sheet->isLevel) return;
  const auto word = [&](SectionPoint at, const char* text) {
    ImFont* font = env.fonts.small;
    const ImVec2 extent = extentOf(font, shown(text)), p = frame.at(at);
    drawLine(list, {font, {p.x - extent.x / 2, p.y - extent.y / 2}, kMuted}, shown(text));
  };
  word({0, 1.09}, words::text("front"));
  word({0, -1.09}, words::text("back"));
  const ImVec2 left = frame.at({-1, 0.07}), right = frame.at({1, 0.07});
  const float size = env.fonts.small->FontSize * ImGui::GetIO().FontGlobalScale;
  const std::string_view toLeft = shown(words::text("left")), toRight = shown(words::text("right"));
  drawLine(list, {env.fonts.small, {left.x + 6, left.y - size / 2}, faded(kMuted, 170)}, toLeft);
  const float wide = extentOf(env.fonts.small, toRight).x;
  drawLine(list, {env.fonts.small, {right.x - wide - 6, right.y - size / 2}, faded(kMuted, 170)}, toRight);
}

void paintPoints(const PanelEnv& env, ImDrawList& list, const SectionFrame& frame) {
  const app::SectionBoard& board = *env.ui().sections.board;
  const float r = env.ui().touch ? 7.f : 5.f;
  for (std::size_t c = 0; c < board.shown().size(); ++c) {
    const auto& points = board.shown()[c].points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const ImVec2 at = frame.at(points[i].at);
      const bool on = board.point == sections::PointRef{c, i};
      const ImU32 ink = on ? kAccent : kInk, inside = on ? kAccent : kSurface;
      if (points[i].corner) {
        list.AddRectFilled({at.x - r, at.y - r}, {at.x + r, at.y + r}, inside, 1);
        list.AddRect({at.x - r, at.y - r}, {at.x + r, at.y + r}, ink, 1, 0, 1.6f);
      } else {
        list.AddCircleFilled(at, r, inside, 16);
        list.AddCircle(at, r, ink, 16, 1.6f);
      }
    }
  }
}

/// The points without a pointer, in hundredths of half the slice's width.
void askedPoints(const PanelEnv& env, const SectionFrame& frame) {
  const sections::Drawing& drawing = env.ui().sections.board->drawing;
  std::size_t all = 0, n = 0;
  for (const sections::DrawnCurve& curve : drawing) all += curve.points.size();
  for (std::size_t c = 0; c < drawing.size(); ++c) {
    for (std::size_t i = 0; i < drawing[c].points.size(); ++i) {
      const words::Args number = {{"n", ++n}, {"all", all}};
      SectionPoint to = drawing[c].points[i].at;
      const auto moved = [&](const char* id, const char* sentence, double& value) {
        const double percent = 100 * value;
        const PointControl what{id + std::to_string(n), words::tr(sentence, number), frame.at(to)};
        const std::string text(words::tr("{n} %", {{"n", std::round(percent)}}));
        const auto asked = pointSlider(env, what, {-100, 100, percent, text});
        if (asked) value = *asked / 100;
        return asked.has_value();
      };
      const bool across = moved("across", "Point {n} of {all}: to the right", to.x);
      const bool front = moved("front", "Point {n} of {all}: to the front", to.y);
      if (across || front) env.sink.run(app::moveBoardPoint, sections::PointRef{c, i}, to);
    }
  }
}

/// The line under the pen with its images.
void paintStroke(const PanelEnv& env, ImDrawList& list, const SectionFrame& frame) {
  const app::SectionBoard& board = *env.ui().sections.board;
  const bool closed = board.tool == app::BoardTool::Box || board.tool == app::BoardTool::Ellipse;
  std::vector<SectionPoint> line = board.stroke;
  if (closed && !line.empty()) line.push_back(line.front());
  if (board.tool == app::BoardTool::Line) {
    line.assign(board.corners.begin(), board.corners.end());
    if (board.stroke.size() == 2) line.push_back(board.stroke[1]);
  }
  if (line.empty()) return;
  const std::size_t count = sections::images(line.front(), board.symmetry).size();
  for (std::size_t k = count; k-- > 0;) {
    std::vector<SectionPoint> image;
    for (const SectionPoint p : line) image.push_back(sections::images(p, board.symmetry)[k]);
    paintLine(list, frame, image, {k == 0 ? kAccent : faded(kAccent, 90), 0, k == 0 ? 2.6f : 1.8f});
  }
  if (board.tool != app::BoardTool::Line) return;
  for (std::size_t i = 0; i < board.corners.size(); ++i) {
    list.AddCircleFilled(frame.at(board.corners[i]), i == 0 ? 7.f : 4.5f, i == 0 ? kGlow : kAccent, 16);
    list.AddCircle(frame.at(board.corners[i]), i == 0 ? 7.f : 4.5f, kAccent, 16, 1.5f);
  }
}

void paintBoard(const PanelEnv& env, const app::Rect& square) {
  app::SectionBoard& board = *env.ui().sections.board;
  board.square = square;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 low{static_cast<float>(square.x), static_cast<float>(square.y)};
  const ImVec2 high{static_cast<float>(square.right()), static_cast<float>(square.bottom())};
  list.AddRectFilled(low, high, kPaper, kRadius);
  list.PushClipRect(low, high, true);
  const app::ClientPoint c = square.centre();
  const SectionFrame frame{{static_cast<float>(c.x), static_cast<float>(c.y)},
                           static_cast<float>(square.width / 2 / app::kBoardReach)};
  paintGround(env, list, frame);
  for (const auto* lines : {&env.ui().sections.traces, &board.below}) {
    const SectionPen pen{faded(kMuted, lines == &board.below ? 150 : 60), 0, 1.4f};
    if (board.traces) paintOutlines(list, frame, *lines, pen);
  }
  const auto problem = sections::problemOf(board.drawing);
  std::vector<std::vector<SectionPoint>> outlines;
  for (const sections::DrawnCurve& curve : board.shown()) outlines.push_back(sections::outlineOf(curve));
  const bool drawing = !board.stroke.empty();
  paintOutlines(list, frame, outlines, {faded(kAccent, drawing ? 110u : 255u), rgb(0xf4a88f, 70), 2.2f});
  if (problem && problem->curve < outlines.size() && !board.live) {
    paintOutlines(list, frame, std::span(&outlines[problem->curve], 1), {kWrong, 0, 3});
  }
  if (board.tool == app::BoardTool::Points) {
    paintPoints(env, list, frame);
    askedPoints(env, frame);
  }
  paintStroke(env, list, frame);
  list.PopClipRect();
}

/// Presets, own sections and earlier lines, in a row that scrolls.
void startRow(const PanelEnv& env, float width) {
  ImGui::BeginChild("start from", {width, kStartTile + 12}, ImGuiChildFlags_None,
                    ImGuiWindowFlags_NoNav | ImGuiWindowFlags_HorizontalScrollbar);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {4, 4});
  const auto put = [&](const char* id, Text tip, const sections::SectionShape& shape) {
    return tile(env, {id, "", tip, {kStartTile, kStartTile}, false},
                [&](ImDrawList& list, ImVec2 centre, float radius, ImU32 ink) {
                  paintSection(list, {centre, radius}, shape, {ink, 0, 1.6f});
                });
  };
  for (const app::ShelfSection& section : env.ui().sections.shelf) {
    const std::string id = "shelf" + std::to_string(section.id);
    if (put(id.c_str(), asIs(words::nameOf(section.name)), section.shape)) {
      env.sink.run(app::startBoardFrom, section.shape);
    }
    ImGui::SameLine();
  }
  for (const sections::SectionName& name : sections::sectionNames()) {
    const std::string id(name.key);
    if (put(id.c_str(), name.label, name.preset)) {
      env.sink.run(app::startBoardFrom, sections::SectionShape(name.preset));
    }
    ImGui::SameLine();
  }
  for (std::size_t i = env.ui().sections.traces.size(); i-- > 0;) {
    const std::string id = "trace" + std::to_string(i);
    sections::SectionShape shape;
    shape.contours = {env.ui().sections.traces[i]};
    if (put(id.c_str(), "An earlier line", shape)) {
      env.sink.run(app::startBoardFromTrace, i);
    }
    ImGui::SameLine();
  }
  ImGui::PopStyleVar();
  dragScroll();
  ImGui::EndChild();
}

std::string_view hintOf(const app::SectionBoard& board) {
  if (board.drawing.empty() && board.corners.empty()) {
    return board.tool == app::BoardTool::Pen ? "Draw the slice in one go, all the way round."
                                             : sections::sentenceOf(sections::DrawingFault::Empty);
  }
  if (const auto problem = sections::problemOf(board.drawing)) return sections::sentenceOf(problem->fault);
  switch (board.tool) {
    case app::BoardTool::Line:
      return "Tap corner after corner; the first one closes the curve.";
    case app::BoardTool::Points:
      return "Drag a point. Tap the line to add one, tap a point twice to take it away.";
    default:
      return "A curve inside is a hole, one outside another piece.";
  }
}

void titleRow(const PanelEnv& env, float width) {
  const float height = buttonSide(env);
  ImGui::AlignTextToFramePadding();
  // As wide as it is: what stands beside it begins at its end, also where lines begin at the right.
  const float own = extentOf(env.fonts.bold, words::drawn(words::tr("Your slice"))).x;
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + std::ceil(own) + 1);
  label(env.fonts.bold, kInk, "Your slice");
  ImGui::PopTextWrapPos();
  if (env.ui().layout.stacked) {
    for (const app::CommandId id : {app::CommandId("slice-undo"), app::CommandId("slice-redo")}) {
      ImGui::SameLine(0, 2);
      commandButton(env, id, height);
    }
  }
  const auto widthOf = [&](app::CommandId id) { return textButtonWidth(env, app::commandOf(id).label); };
  const float done = widthOf("slice-done") + 12, leave = widthOf("slice-cancel");
  // At the end of the row; below it, and below each other, where that is too short.
  const float start = ImGui::GetStyle().WindowPadding.x + width - done - leave - 6;
  const float taken = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x;
  if (start >= taken + 4) ImGui::SameLine(start);
  commandText(env, {"slice-cancel", std::min(leave, width)});
  if (done + leave + 6 <= width) ImGui::SameLine(0, 6);
  commandText(env, {"slice-done", std::min(done, width), true});
}

}  // namespace

void drawSectionBoard(const PanelEnv& env) {
  if (!env.ui().sections.board) return;
  app::UiState& ui = env.ui();
  const app::Rect card = ui.layout.picture;
  ui.overlays.push_back(card);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {10, 8});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {4, 4});
  beginFixed("slice board", card);
  const bool wide = card.width > card.height * 1.15;  // the tools stand beside the square
  const float inner = static_cast<float>(card.width) - 20;
  const float side = static_cast<float>(card.height) - 16;
  const float column = wide ? inner - std::min(side, inner * 0.62f) - 10 : inner;
  if (wide) ImGui::BeginGroup();
  titleRow(env, column);
  toolbar(env, column);
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + column);
  const app::SectionBoard& board = *ui.sections.board;
  const bool wrong = !board.past.empty() && !board.drawing.empty() && sections::problemOf(board.drawing);
  label(env.fonts.small, wrong ? kWrong : kMuted, hintOf(board));
  ImGui::PopTextWrapPos();
  app::Rect square;
  if (wide) {
    startRow(env, column);
    ImGui::EndGroup();
    const double length = std::min<double>(side, inner - column - 10);
    square = {card.right() - 10 - length, card.y + (card.height - length) / 2, length, length};
  } else {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const double room = card.bottom() - 8 - at.y - (kStartTile + 18);
    const double length = std::max(120.0, std::min<double>(inner, room));
    square = {card.x + 10 + (inner - length) / 2, at.y, length, length};
    ImGui::SetCursorScreenPos({at.x, at.y + static_cast<float>(length) + 6});
    startRow(env, inner);
  }
  paintBoard(env, square);
  ImGui::End();
  ImGui::PopStyleVar(3);
}

}  // namespace spineloft::panels
