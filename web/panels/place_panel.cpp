// Where the selected part stands, in numbers that can be typed.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "web/commands/intents.h"
#include "web/edit/placing.h"
#include "web/panels/theme.h"
#include "web/panels/widgets.h"

namespace spineloft::panels {
namespace {

struct Field {
  const char* key;
  const char* word;
  const char* unit;
};
constexpr std::array kFields = {Field{"x", "Right", "{n} mm"},        Field{"y", "Up", "{n} mm"},
                                Field{"z", "Front", "{n} mm"},        Field{"tip", "Tip", "{n}\xc2\xb0"},
                                Field{"turn", "Turn", "{n}\xc2\xb0"}, Field{"lean", "Lean", "{n}\xc2\xb0"}};

/// A word above a number in a box; a press asks for another number.
void field(const PanelEnv& env, const Field& what, double value, float width) {
  const float height = env.ui().touch ? 48.f : 40.f;
  ImGui::PushID(what.key);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool pressed = ImGui::InvisibleButton("box", {width, height});
  registerControl(env, app::Control::Kind::Field, what.word);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool hot = ImGui::IsItemHovered();
  list.AddRectFilled(at, {at.x + width, at.y + height}, kTile, 8);
  list.AddRect(at, {at.x + width, at.y + height}, hot ? kMuted : kLine, 8);
  const std::string_view text = shown(asIs(words::tr(what.unit, {{"n", std::round(value * 10) / 10 + 0.0}})));
  ImFont* small = env.fonts.small;
  const float size = small->FontSize * ImGui::GetIO().FontGlobalScale;
  list.PushClipRect(at, {at.x + width, at.y + height}, true);
  drawLine(list, {small, {at.x + 8, at.y + 4}, kMuted}, shortened(small, what.word, width - 12));
  drawLine(list, {small, {at.x + 8, at.y + height - size - 5}, kInk}, text);
  list.PopClipRect();
  ImGui::PopID();
  if (pressed) env.sink.run(app::askPlace, what.key);
}

/// A thing and its other side, with the plane between them; of front and back the one behind the other.
void paintSides(ImDrawList& list, const app::MirrorAxis& axis, ImVec2 c, float r, ImU32 colour) {
  const bool across = axis.normal.x != 0, upright = axis.normal.y != 0;
  const ImU32 faint = faded(kMuted, 110);
  const ImVec2 off = across ? ImVec2(r * 0.55f, 0) : upright ? ImVec2(0, r * 0.5f) : ImVec2(r * 0.28f, -r * 0.28f);
  const float size = r * 0.36f;
  list.AddCircleFilled({c.x + off.x, c.y + off.y}, size, faint, 20);
  list.AddCircleFilled({c.x - off.x, c.y - off.y}, size, colour, 20);
  if (across) list.AddLine({c.x, c.y - r}, {c.x, c.y + r}, faint, 1.4f);
  if (upright) list.AddLine({c.x - r, c.y}, {c.x + r, c.y}, faint, 1.4f);
  if (!across && !upright) list.AddLine({c.x - r, c.y - r}, {c.x + r, c.y + r}, faint, 1.4f);
}

}  // namespace

void sidesTiles(const PanelEnv& env, const document::MirrorPlane& mirror, float width) {
  constexpr float kGap = 6;
  const auto axes = app::mirrorAxes();
  const auto count = static_cast<float>(axes.size());
  const float each = std::floor((width - kGap * (count - 1)) / count);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {kGap, kGap});
  for (const app::MirrorAxis& axis : axes) {
    if (&axis != &axes.front()) ImGui::SameLine();
    const bool on = app::isAcross(mirror, axis);
    const auto paint = [&](ImDrawList& list, ImVec2 centre, float radius, ImU32 colour) {
      paintSides(list, axis, centre, radius, colour);
    };
    if (tile(env, {axis.key, axis.brief, axis.words, {each, 56}, on, axis.words}, paint) && !on) {
      env.sink.run(app::setSymmetry, &axis);
    }
  }
  ImGui::PopStyleVar();
}

void placePanel(const PanelEnv& env, float width) {
  const document::Part* part = env.selected();
  if (part == nullptr) {
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
    label(env.fonts.small, kMuted, "Choose a part first.");
    ImGui::PopTextWrapPos();
    return;
  }
  const double mm = app::mmPerUnit(env.document(), env.derived);
  const bool strip = env.ui().layout.strip;
  const int columns = strip && width >= 560 ? 7 : 3;
  const float gap = 6;
  const float each = (width - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
  for (std::size_t i = 0; i < kFields.size(); ++i) {
    if (i % static_cast<std::size_t>(columns) != 0) ImGui::SameLine();
    field(env, kFields[i], app::placeNumber(*part, kFields[i].key, mm), each);
  }
  if (columns == 7) ImGui::SameLine();
  field(env, {"size", "Size", "{n} %"}, app::placeNumber(*part, "size", mm), each);
  const float side = buttonSide(env);
  constexpr app::CommandId kButtons[] = {"drop-on-floor", "face-front", "duplicate", "mirror-copy", "symmetry"};
  for (const app::CommandId& id : kButtons) {
    if (columns != 7 || &id != &kButtons[0]) ImGui::SameLine(0, 2);
    if (ImGui::GetContentRegionAvail().x < side) ImGui::NewLine();
    commandButton(env, id, side);
  }
  if (part->mirror) {
    label(env.fonts.small, kMuted, "Alike on both sides");
    sidesTiles(env, *part->mirror, std::min(width, 300.f));
  }
  ImGui::PopStyleVar();
}

}  // namespace spineloft::panels
