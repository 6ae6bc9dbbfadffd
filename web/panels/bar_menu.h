// Bars of buttons, in one row or several: what does not fit waits behind a button with three dots.
#pragma once

#include <imgui.h>

#include <functional>
#include <span>
#include <string_view>

#include "web/panels/panels.h"
#include "web/panels/short_list.h"

namespace spineloft::panels {

/// The commands of a bar, in their order.
struct BarSplit {
  ShortList<app::CommandId> shown;  ///< in the row
  ShortList<app::CommandId> rest;   ///< in the menu; where it is not empty its button is the row's last
  std::size_t cells() const { return shown.size() + (rest.empty() ? 0 : 1); }
};

/// `ids`, the most used first, into a row of `room` cells, at least one: all where they fit, else the
/// first ones and the menu's button. What `inUse` says of stays in the row, in the last one's place.
BarSplit splitBar(std::span<const app::CommandId> ids, std::size_t room,
                  const std::function<bool(app::CommandId)>& inUse);

/// Where a button of a bar stands.
struct BarCell {
  app::CommandId id;
  double width = 0;
  int row = 0;
};
using BarCells = ShortList<BarCell>;
inline constexpr double kCellGap = 2;  ///< between two of them

/// In rows of about the same width, none wider than `room` but for a single button; as wide as words need, or `side`.
BarCells arrangeCells(const PanelEnv& env, std::span<const app::CommandId> ids, bool words, double room, double side);
int rowsOf(const BarCells& cells);
double widestRow(const BarCells& cells);

/// Whether it is a tool, and the one in use.
bool isToolInUse(const PanelEnv& env, app::CommandId id);

/// The button of the menu, in the row of its bar.
void barMenuButton(const PanelEnv& env, app::BarMenu which, float side);
/// The menu beside `bar`, while it is open: a column of words, or two where the canvas is low.
/// `colour`: of what is switched on.
void barMenu(const PanelEnv& env, app::BarMenu which, const BarSplit& split, const app::Rect& bar, ImU32 colour);

}  // namespace spineloft::panels
