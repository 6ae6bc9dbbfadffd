#include "web/panels/bar_menu.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "web/panels/theme.h"
#include "web/panels/widgets.h"

namespace spineloft::panels {
namespace {

constexpr double kEdge = 6, kGap = 2, kPadding = 4;

struct Grid {
  std::size_t rows = 1, columns = 1;
  double cell = 0;  ///< width
  double width() const { return static_cast<double>(columns) * (cell + kGap) - kGap + 2 * kPadding; }
  double height(double side) const { return static_cast<double>(rows) * (side + kGap) - kGap + 2 * kPadding; }
};

/// In as many columns as `room` for the height asks for.
Grid gridFor(std::size_t count, double cell, double side, double room) {
  Grid grid{count, 1, cell};
  while (grid.rows > 1 && grid.height(side) > room) {
    ++grid.columns;
    grid.rows = (count + grid.columns - 1) / grid.columns;
  }
  return grid;
}

bool isColumn(const app::Rect& bar) { return bar.height > bar.width; }

Grid gridFor(const PanelEnv& env, const BarSplit& split, const app::Rect& bar, double side) {
  double cell = 0;
  for (const app::CommandId id : split.rest) {
    cell = std::max<double>(cell, wordButtonWidth(env, app::commandOf(id).label, static_cast<float>(side)));
  }
  cell = std::ceil(cell);
  const double canvas = env.ui().canvasHeight - 2 * kEdge;
  const double beside = isColumn(bar) ? canvas : std::max(bar.y, env.ui().canvasHeight - bar.bottom()) - 2 * kEdge;
  Grid clear = gridFor(split.rest.size(), cell, side, beside);
  // Beside a column rather with shorter words than over it.
  const auto columns = static_cast<double>(clear.columns);
  const double narrow = (bar.x - 2 * kEdge - 2 * kPadding + kGap) / columns - kGap;
  if (isColumn(bar) && narrow >= 2 * side) clear.cell = std::floor(std::min(clear.cell, narrow));
  // Rather over its bar than wider than the canvas.
  return clear.width() <= env.ui().canvasWidth - 2 * kEdge ? clear : gridFor(split.rest.size(), cell, side, canvas);
}

/// Beside a column; above a row where it fits there, else below.
app::Rect placeOf(const PanelEnv& env, const app::Rect& bar, double width, double height) {
  const double right = env.ui().canvasWidth, foot = env.ui().canvasHeight;
  const bool column = isColumn(bar);
  double x = column ? bar.x - kEdge - width : bar.right() - width;
  double y = bar.bottom() - height;
  if (!column) y = bar.y >= height + 2 * kEdge ? bar.y - kEdge - height : bar.bottom() + kEdge;
  x = std::clamp(x, kEdge, std::max(kEdge, right - kEdge - width));
  y = std::clamp(y, kEdge, std::max(kEdge, foot - kEdge - height));
  return {x, y, width, height};
}

/// Puts cells into as few rows as `room` allows; how many those are.
int breakRows(BarCells& cells, double room) {
  double x = 0;
  int row = 0;
  for (BarCell& cell : cells) {
    if (x > 0 && x + cell.width > room) {
      x = 0;
      ++row;
    }
    cell.row = row;
    x += cell.width + kCellGap;
  }
  return row + 1;
}

}  // namespace

BarCells arrangeCells(const PanelEnv& env, std::span<const app::CommandId> ids, bool words, double room, double side) {
  BarCells cells;
  double width = 0;
  for (const app::CommandId id : ids) {
    cells.push_back({id, words ? static_cast<double>(commandButtonWidth(env, id)) : side, 0});
    width += cells.back().width + kCellGap;
  }
  const int rows = breakRows(cells, room);
  if (rows == 1) return cells;
  // No row of a single button below a full one.
  double narrow = width / rows;
  while (narrow < room && breakRows(cells, narrow) > rows) narrow += kCellGap;
  breakRows(cells, std::min(narrow, room));
  return cells;
}

int rowsOf(const BarCells& cells) { return cells.empty() ? 1 : cells.back().row + 1; }

double widestRow(const BarCells& cells) {
  double widest = 0;
  for (int row = 0; row < rowsOf(cells); ++row) {
    double width = -kCellGap;
    for (const BarCell& cell : cells) width += cell.row == row ? cell.width + kCellGap : 0;
    widest = std::max(widest, width);
  }
  return widest;
}

BarSplit splitBar(std::span<const app::CommandId> ids, std::size_t room,
                  const std::function<bool(app::CommandId)>& inUse) {
  BarSplit out;
  const std::size_t most = ids.size() <= room ? ids.size() : std::max<std::size_t>(room, 1) - 1;
  for (std::size_t i = 0; i < ids.size(); ++i) (i < most ? out.shown : out.rest).push_back(ids[i]);
  const auto used = std::ranges::find_if(out.rest, inUse);
  if (used != out.rest.end() && !out.shown.empty()) {
    std::swap(out.shown.back(), *used);
    // What gave way comes first in the menu, as it did in the bar.
    std::rotate(out.rest.begin(), used, used + 1);
  }
  return out;
}

bool isToolInUse(const PanelEnv& env, app::CommandId id) {
  const app::Command& command = app::commandOf(id);
  return command.group == "tool" && command.toggled != nullptr && command.toggled(env.env);
}

void barMenuButton(const PanelEnv& env, app::BarMenu which, float side) {
  app::BarMenu& open = env.ui().barMenu;
  const bool on = open == which;
  if (iconButton(env, {"more", "ellipsis", "More", on, true, side})) open = on ? app::BarMenu::None : which;
}

void barMenu(const PanelEnv& env, app::BarMenu which, const BarSplit& split, const app::Rect& bar, ImU32 colour) {
  app::BarMenu& open = env.ui().barMenu;
  if (open != which) return;
  if (split.rest.empty()) {  // there is room for all now
    open = app::BarMenu::None;
    return;
  }
  const double side = std::max(44.f, buttonSide(env));
  const Grid grid = gridFor(env, split, bar, side);
  const app::Rect card = placeOf(env, bar, grid.width(), grid.height(side));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, kRadius);
  beginCard(env, "bar menu", card);
  ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
  const bool emptyBefore = env.sink.empty();
  for (std::size_t i = 0; i < split.rest.size(); ++i) {
    if (i % grid.columns != 0) ImGui::SameLine();
    wordButton(env, {split.rest[i], static_cast<float>(grid.cell), static_cast<float>(side), colour});
  }
  const ImVec2 at = ImGui::GetIO().MousePos;
  const app::ClientPoint pointer{at.x, at.y};
  const bool elsewhere = ImGui::IsMouseClicked(0) && !card.contains(pointer) && !bar.contains(pointer);
  if (elsewhere || (emptyBefore && !env.sink.empty())) open = app::BarMenu::None;
  endCard();
  ImGui::PopStyleVar();
}

}  // namespace spineloft::panels
