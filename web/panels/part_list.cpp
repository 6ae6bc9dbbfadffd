// The parts in their order: chosen, taken in hand together, dragged to other places.
#include <imgui.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "web/commands/intents.h"
#include "web/edit/placing.h"
#include "web/panels/solid_list.h"
#include "web/panels/theme.h"
#include "web/panels/widgets.h"

namespace spineloft::panels {
namespace {

constexpr float kIndent = 14;   // of the parts of a group, CSS pixels
constexpr float kDragSlop = 6;  // CSS pixels
constexpr float kNameGap = 4;   // behind a name, CSS pixels

/// Where a row of the list is, and what stands in it.
struct Place {
  app::ListRow row;
  std::vector<PartId> parts;
  float top = 0, bottom = 0;
};

/// All that a solid is made of, in the order of the list.
std::vector<PartId> partsOf(const PanelEnv& env, const document::Step& root) {
  const std::vector<PartId> within = partsIn(env.document(), {{}, root.id});
  std::vector<PartId> out;
  for (const document::Part& part : env.document().parts) {
    if (std::ranges::count(within, part.id) > 0) out.push_back(part.id);
  }
  return out;
}

bool draggedFar() { return ImGui::GetIO().MouseDragMaxDistanceSqr[0] >= kDragSlop * kDragSlop; }

/// Shift, or a finger that stays, takes one more part in hand.
bool takesMore() { return wasLongPress() || ImGui::GetIO().KeyShift || ImGui::GetIO().KeyCtrl; }

/// The part as a small picture.
void picture(const PanelEnv& env, const document::Part& part, ImVec2 low, float side) {
  const gl::SceneTexture* texture = env.pictures.of(env.document(), env.derived, part);
  if (texture == nullptr) return;
  const ImU32 tint = part.visible ? IM_COL32_WHITE : faded(IM_COL32_WHITE, 90);
  // Dear ImGui keeps the address; the renderer knows what it is of.
  ImGui::GetWindowDrawList()->AddImage(const_cast<gl::SceneTexture*>(texture), low, {low.x + side, low.y + side},
                                       {0, 0}, {1, 1}, tint);
}

/// `indent` is not 0 for a part of a solid, which shows and hides as a whole.
void row(const PanelEnv& env, const document::Part& part, float indent, float width) {
  const bool selected = part.id == env.ui().selection;
  const bool inHand = app::isSelected(env.document(), env.ui(), part.id);
  const bool elsewhere = document::pictureOf(part) != env.ui().picture;
  const float height = buttonSide(env);
  const bool free = indent <= 0, ticks = free && canTick(env, {part.id, {}});
  const float grips = height;  // with the picture in it
  const std::string_view called = words::nameOf(part.name);
  const float others = height * (static_cast<float>(free) + static_cast<float>(ticks));
  // The bar deletes a part as well: the bin is where the name has room beside it.
  const float besideBin = width - indent - others - height - grips - kNameGap;
  const bool bins = selected && !holdsWhole(env) && extentOf(ImGui::GetFont(), words::drawn(called)).x <= besideBin;
  const float buttons = others + (bins ? height : 0);
  ImGui::PushID(static_cast<int>(part.id.value));
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + indent);
  width -= indent;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (inHand) markOn(list, at, {at.x + width, at.y + height}, kAccentSoft);
  const bool tapped = grip(env, {part.id, {}}, {grips, height}, part.name);
  ImGui::SameLine(0, 0);
  const bool pressed = ImGui::InvisibleButton("row", {width - buttons - grips, height}) || tapped;
  registerControl(env, app::Control::Kind::Row, part.name, true, inHand);
  if (!inHand && ImGui::IsItemHovered()) {
    list.AddRectFilled(at, {at.x + width, at.y + height}, kHover, 8);
  }
  showRow(env, {part.id, {}}, at.x + grips);
  picture(env, part, {at.x + 5, at.y + 3}, height - 6);
  const float textHeight = ImGui::GetTextLineHeight();
  const std::string_view name = shortened(ImGui::GetFont(), asIs(called), width - buttons - grips - kNameGap);
  const ImU32 ink = !part.visible ? faded(kMuted, 150) : elsewhere ? kMuted : inHand ? kAccent : kInk;
  drawLine(list, {ImGui::GetFont(), {at.x + grips + 3, at.y + (height - textHeight) / 2}, ink}, name);
  if (elsewhere) {
    const document::PictureEntry* picture = findPicture(env.document(), document::pictureOf(part));
    if (picture != nullptr) tooltip(asIs(words::tr("On {name}", {{"name", words::nameOf(picture->name)}})));
  }
  if (pressed) {
    // Of the only one in hand a finger that stays asks for another name.
    const bool only = selected && env.ui().alsoSelected.empty();
    if (selected && (secondClick() || (only && wasLongPress()))) {
      env.sink.run(app::askPartName, part.id);
    } else if (takesMore()) {
      env.sink.run(app::selectPart, part.id, true);
    } else {
      env.sink.run(app::selectPart, part.id, false);
    }
  }
  if (ticks) {
    ImGui::SameLine(0, 0);
    tickButton(env, {part.id, {}}, height);
  }
  const std::string_view eye = part.visible ? "eye" : "eye-off";
  const std::string_view tip = part.visible ? "Hide" : "Show";
  if (free) {
    ImGui::SameLine(0, 0);
    if (iconButton(env, {"eye", eye, tip, false, true, height})) {
      env.sink.run(app::showPart, part.id, !pipeline::isVisible(env.document(), part));
    }
  }
  if (bins) {
    ImGui::SameLine(0, 0);
    if (namedButton(env, "delete-part", height)) env.sink.run(app::deletePart, part.id);
  }
  ImGui::PopID();
}

/// The name of a group above its parts: a press takes them all in hand.
void groupRow(const PanelEnv& env, const document::Group& group, const Place& place, float width) {
  const float height = place.bottom - place.top;
  ImGui::PushID(static_cast<int>(group.id.value));
  ImGui::PushID("group");
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool tapped = grip(env, place.row, {24, height}, group.name);
  ImGui::SameLine(0, 0);
  const bool pressed = ImGui::InvisibleButton("row", {width - 24 - height, height}) || tapped;
  registerControl(env, app::Control::Kind::Row, group.name);
  showRow(env, place.row, at.x + 24);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (ImGui::IsItemHovered()) list.AddRectFilled(at, {at.x + width, at.y + height}, kHover, 8);
  const float size = env.fonts.bold->FontSize * ImGui::GetIO().FontGlobalScale;
  list.PushClipRect(at, {at.x + width - height, at.y + height}, true);
  list.AddText(env.fonts.icons, size * 1.1f, {at.x + 8, at.y + (height - size * 1.1f) / 2}, kMuted, iconText("group"));
  drawLine(list, {env.fonts.bold, {at.x + 30, at.y + (height - size) / 2}, kInk},
           words::drawn(words::nameOf(group.name)));
  list.PopClipRect();
  if (pressed && (secondClick() || wasLongPress())) {
    env.sink.run(app::askGroupName, group.id);
  } else if (pressed) {
    env.sink.run(app::selectPart, place.parts.front(), false);
  }
  ImGui::SameLine(0, 0);
  if (namedButton(env, "ungroup", height)) env.sink.run(app::ungroup, group.id);
  ImGui::PopID();
  ImGui::PopID();
}

/// A row that is dragged has a frame; a line where it would go, and the move when it is let go.
void dragRows(const PanelEnv& env, const std::vector<Place>& places, float width) {
  const std::optional<app::ListRow> dragged = env.ui().listDrag;
  if (!dragged) return;
  const bool moved = draggedFar();
  const auto own = std::ranges::find(places, *dragged, &Place::row);
  const float y = ImGui::GetIO().MousePos.y;
  const auto next =
      std::ranges::find_if(places, [&](const Place& place) { return y < (place.top + place.bottom) / 2; });
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float x = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMin().x;
  if (own != places.end()) list.AddRect({x, own->top}, {x + width, own->bottom}, kAccent, 8, 0, 2);
  if (moved && own != places.end()) {
    const float line = next == places.end() ? places.back().bottom : next->top - 1;
    list.AddRectFilled({x, line - 1.5f}, {x + width, line + 1.5f}, kAccent, 1.5f);
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  }
  if (ImGui::IsMouseDown(0)) return;
  env.ui().listDrag.reset();
  if (!draggedFar()) {
    if (dragged->step) return env.sink.run(app::selectStep, dragged->step);
    env.sink.run(app::selectPart, dragged->part, takesMore());
    return;
  }
  if (own == places.end()) return;
  const PartId before = next == places.end() ? PartId{} : next->parts.front();
  if (std::ranges::count(own->parts, before) > 0) return;
  env.sink.run(app::moveInList, own->parts, before);
}

}  // namespace

void partList(const PanelEnv& env, bool tiles) {
  const auto& parts = env.document().parts;
  const float width = ImGui::GetContentRegionAvail().x;
  if (parts.empty()) {
    const document::PictureEntry* picture = findPicture(env.document(), env.ui().picture);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
    const app::ToolKind tool = env.ui().tool;
    const bool byLine = tool == app::ToolKind::Draw || tool == app::ToolKind::Pen || tool == app::ToolKind::Eraser;
    const bool onPaper = picture != nullptr && picture->isSketch();
    label(env.fonts.small, kMuted,
          !byLine   ? "No part yet."  // the picture says what to do with the tool
          : onPaper ? "No part yet. Draw the outline of a thing, then a line along its middle."
                    : "No part yet. Draw one line along the middle of the thing in the picture.");
    ImGui::PopTextWrapPos();
    return;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {6, 2});
  std::vector<Place> places;
  std::set<StepId> drawn;
  GroupId above;
  for (const document::Part& part : parts) {
    const document::Step* root = rootOf(env.document(), {part.id, {}});
    if (root != nullptr) {
      above = {};
      if (!drawn.insert(root->id).second) continue;
      const float y = ImGui::GetCursorScreenPos().y;
      solidRows(env, *root, width, [&](const document::Part& inner, float indent) { row(env, inner, indent, width); });
      places.push_back({{{}, {}, root->id}, partsOf(env, *root), y, ImGui::GetCursorScreenPos().y});
      continue;
    }
    const document::Group* group = document::findGroup(env.document(), part.group);
    const float height = buttonSide(env);
    if (group != nullptr && part.group != above) {
      const float y = ImGui::GetCursorScreenPos().y;
      std::vector<PartId> members = document::partsOfGroup(env.document(), group->id);
      const app::ListRow header{members.front(), group->id};
      places.push_back({header, std::move(members), y, y + height});
      groupRow(env, *group, places.back(), width);
    }
    above = part.group;
    const float indent = group != nullptr ? kIndent : 0;
    if (indent > 0) ImGui::Indent(indent);
    const float y = ImGui::GetCursorScreenPos().y;
    places.push_back({{part.id, {}}, {part.id}, y, y + height});
    row(env, part, 0, width - indent);
    if (indent > 0) ImGui::Unindent(indent);
  }
  solidPanel(env, width, tiles);
  ImGui::PopStyleVar();
  dragRows(env, places, width);
}

}  // namespace spineloft::panels
