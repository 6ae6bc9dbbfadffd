// Rows of the part list that are about solids made of parts.
#pragma once

#include <imgui.h>

#include "web/panels/panels.h"

namespace spineloft::panels {

/// The drawing at the left of a row is what it is dragged by: at once by a mouse, by a finger after it has stayed,
/// since before that it scrolls the list. True when a finger tapped it.
bool grip(const PanelEnv& env, const app::ListRow& row, ImVec2 size, std::string_view name);

/// A solid that stands alone, with what it is made of below it; `partRow(part, indent)` draws a part's row.
template <class PartRow>
void solidRows(const PanelEnv& env, const document::Step& step, float width, const PartRow& partRow);

/// The row of a solid itself, `indent` from the left. True while its parts are to be shown below.
bool solidRow(const PanelEnv& env, const document::Step& step, float indent, float width);
/// The tick of a part or solid that stands alone; nothing for others.
void tickButton(const PanelEnv& env, document::Operand operand, float size);
/// Whether all of the chosen solid is in hand.
bool holdsWhole(const PanelEnv& env);
/// Whether there is more than one thing to put together.
bool canTick(const PanelEnv& env, document::Operand operand);
/// Below the list: what went wrong, and the measures of the chosen solid; with `tiles`, solidTiles() before them.
void solidPanel(const PanelEnv& env, float width, bool tiles);
/// What can be made of the ticked parts, `columns` side by side. False where there is nothing to show.
bool hasSolidTiles(const PanelEnv& env);
void solidTiles(const PanelEnv& env, float width, int columns);

template <class PartRow>
void solidRows(const PanelEnv& env, const document::Step& step, float width, const PartRow& partRow) {
  struct Row {
    document::Operand operand;
    float indent;
  };
  constexpr float kIndent = 16;
  std::vector<Row> rows{{{{}, step.id}, 0.f}};
  // What is inside comes right below; a forest, so that it ends.
  while (!rows.empty()) {
    const auto [operand, indent] = rows.back();
    rows.pop_back();
    if (operand.part) {
      if (const document::Part* part = findPart(env.document(), operand.part)) partRow(*part, indent);
      continue;
    }
    const document::Step* inner = findStep(env.document(), operand.step);
    if (inner == nullptr || !solidRow(env, *inner, indent, width)) continue;
    for (auto at = inner->operands.rbegin(); at != inner->operands.rend(); ++at) {
      rows.push_back({*at, indent + kIndent});
    }
  }
}

/// Tells where the row whose button was the last item can be renamed, from `left` to its end, where that is in sight.
void showRow(const PanelEnv& env, const app::ListRow& row, float left);
/// The press that was just let go was the second of two in quick succession: a press on a button counts when it is let
/// go, when ImGui tells of a double click no more.
bool secondClick();

}  // namespace spineloft::panels
