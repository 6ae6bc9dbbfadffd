// The parts, in the order they were drawn.
#include <imgui.h>

#include <string>

#include "web/panels/theme.h"
#include "web/panels/widgets.h"

namespace spineloft::panels {
namespace {

void row(const PanelEnv& env, const document::Part& part, float width) {
  const bool selected = part.id == env.ui().selection;
  const bool elsewhere = document::pictureOf(part) != env.ui().picture;
  const float height = buttonSide(env);
  const float buttons = height + (selected ? height : 0);
  ImGui::PushID(static_cast<int>(part.id.value));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool pressed = ImGui::InvisibleButton("row", {width - buttons, height});
  if (selected || ImGui::IsItemHovered()) {
    list.AddRectFilled(at, {at.x + width, at.y + height}, selected ? kAccentSoft : kHover, 8);
  }
  const auto& c = part.look.colour;
  const ImVec2 dot{at.x + 15, at.y + height / 2};
  list.AddCircleFilled(dot, 6.5f, part.look.textured ? kPaper : IM_COL32(c[0], c[1], c[2], 255),
                       24);
  list.AddCircle(dot, 6.5f, part.look.textured ? kMuted : rgb(0x1f2430, 60), 24, 1.3f);
  const float textHeight = ImGui::GetTextLineHeight();
  list.PushClipRect(at, {at.x + width - buttons, at.y + height}, true);
  list.AddText({at.x + 30, at.y + (height - textHeight) / 2},
               !part.visible ? rgb(0x5c6474, 150)
               : elsewhere   ? kMuted
               : selected    ? kAccent
                             : kInk,
               part.name.c_str());
  list.PopClipRect();
  if (elsewhere) {
    const document::PictureEntry* picture = findPicture(env.document(), document::pictureOf(part));
    if (picture != nullptr) tooltip("On " + picture->name);
  }
  if (pressed) {
    if (selected && ImGui::IsMouseDoubleClicked(0)) {
      env.sink.run("rename-part", app::Json::Object{{"part", part.id.value}});
    } else {
      env.sink.run("select-part", app::Json::Object{{"id", part.id.value}});
    }
  }
  ImGui::SameLine(0, 0);
  const app::Json::Object which{{"part", part.id.value}};
  const std::string_view eye = part.visible ? "eye" : "eye-off";
  const std::string_view tip = part.visible ? "Hide" : "Show";
  if (iconButton(env, {"eye", eye, tip, false, true, height})) env.sink.run("show-part", which);
  if (selected) {
    ImGui::SameLine(0, 0);
    if (iconButton(env, {"trash", "trash-2", "Delete  (Delete)", false, true, height})) {
      env.sink.run("delete-part", which);
    }
  }
  ImGui::PopID();
}

}  // namespace

void partList(const PanelEnv& env) {
  const auto& parts = env.document().parts;
  const float width = ImGui::GetContentRegionAvail().x;
  if (parts.empty()) {
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
    label(env.fonts.small, kMuted,
          "No part yet. Draw one line along the middle of the thing in the picture.");
    ImGui::PopTextWrapPos();
    return;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {6, 2});
  for (const document::Part& part : parts) row(env, part, width);
  ImGui::PopStyleVar();
}

}  // namespace spineloft::panels
