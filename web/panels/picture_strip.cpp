#include "web/panels/picture_strip.h"
#include "web/commands/intents.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "web/panels/theme.h"
#include "web/panels/widgets.h"

namespace spineloft::panels {
namespace {

constexpr float kSide = 44;  // CSS pixels: what a finger hits
constexpr float kWidest = 68;
constexpr float kMenuWidth = 150;

/// The whole picture within its button.
app::Rect within(ImVec2 at, ImVec2 room, image::Size size) {
  const double scale = std::min((room.x - 4.) / size.width, (room.y - 4.) / size.height);
  const double width = std::max(6., size.width * scale), height = std::max(6., size.height * scale);
  return {at.x + (room.x - width) / 2, at.y + (room.y - height) / 2, width, height};
}

void frame(ImDrawList& list, const app::Rect& at, bool shown, bool hovered) {
  const float out = shown ? 2.f : 1.f;
  const ImVec2 low{static_cast<float>(at.x) - out, static_cast<float>(at.y) - out};
  const ImVec2 high{static_cast<float>(at.right()) + out, static_cast<float>(at.bottom()) + out};
  list.AddRect(low, high, shown ? kAccent : hovered ? kMuted : kLine, 4, 0, shown ? 2.5f : 1.2f);
  if (!shown) return;
  // Three dots say that there is a menu.
  const ImVec2 centre{high.x - 10, high.y - 7};
  list.AddRectFilled({centre.x - 9, centre.y - 5}, {centre.x + 8, centre.y + 5}, faded(kHalo, 225), 4);
  for (const float dx : {-5.f, 0.f, 5.f}) {
    list.AddCircleFilled({centre.x + dx - 0.5f, centre.y}, 1.5f, kInk, 8);
  }
}

void thumbnail(const PanelEnv& env, const document::PictureEntry& entry, bool column) {
  app::UiState& ui = env.ui();
  const double aspect = static_cast<double>(entry.size.width) / std::max(1, entry.size.height);
  const ImVec2 room{std::clamp(static_cast<float>(kSide * aspect), kSide, column ? kSide : kWidest), kSide};
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushID(static_cast<int>(entry.id.value));
  const bool shown = entry.id == ui.picture;
  const bool pressed = ImGui::InvisibleButton("picture", room);
  registerControl(env, app::Control::Kind::Button, entry.name, true, shown);
  const app::Rect image = within(at, room, entry.size);
  ui.thumbnails.push_back({entry.id, image});
  frame(*ImGui::GetWindowDrawList(), image, shown, ImGui::IsItemHovered());
  const bool held = ImGui::IsItemActive() && longPress();
  const bool second = ImGui::IsItemHovered() && ImGui::IsMouseClicked(1);
  if (held) ImGui::ClearActiveID();
  if (held || second || (pressed && shown)) {
    ui.pictureMenu = ui.pictureMenu == entry.id ? PictureId{} : entry.id;
  } else if (pressed) {
    env.sink.run(app::selectPicture, entry.id);
  }
  tooltip(asIs(words::nameOf(entry.name)));
  ImGui::PopID();
}

/// As wide as its words need.
float menuWidth(const PanelEnv& env) {
  float widest = 0;
  for (const app::CommandId id :
       {app::CommandId("side-picture"), app::CommandId("rename-picture"), app::CommandId("remove-picture")}) {
    widest = std::max(widest, extentOf(env.fonts.text, shown(app::commandOf(id).label)).x);
  }
  return std::max(kMenuWidth, widest + 60);
}

/// The row of a command that is told which picture it is about.
bool menuRow(const PanelEnv& env, const app::Command& command, bool on = false) {
  const float height = env.ui().touch ? 44.f : 34.f, width = menuWidth(env) - 8;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool pressed = ImGui::InvisibleButton(command.icon.data(), {width, height});
  registerControl(env, app::Control::Kind::Button, command.label, true, on);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (on) markOn(list, at, {at.x + width, at.y + height}, kAccentSoft);
  if (ImGui::IsItemHovered()) {
    list.AddRectFilled(at, {at.x + width, at.y + height}, kHover, 8);
  }
  const float scale = ImGui::GetIO().FontGlobalScale;
  ImFont *icons = env.fonts.icons, *font = env.fonts.text;
  const float size = icons->FontSize * scale, line = font->FontSize * scale;
  list.AddText(icons, size, {at.x + 9, at.y + (height - size) / 2}, kInk, iconText(command.icon));
  drawLine(list, {font, {at.x + 18 + size, at.y + (height - line) / 2}, kInk}, shown(command.label));
  return pressed;
}

/// What is done with a picture, below (or beside) it.
void menu(const PanelEnv& env, const app::Rect& strip) {
  app::UiState& ui = env.ui();
  const auto at = std::ranges::find(ui.thumbnails, ui.pictureMenu, &app::Thumbnail::picture);
  if (at == ui.thumbnails.end()) return;
  const bool column = strip.height > strip.width;
  const document::PictureEntry* entry = document::findPicture(env.document(), ui.pictureMenu);
  const bool sides = env.document().pictures.size() > 1, isSide = entry && entry->view;
  const double height = (sides ? 3 : 2) * (ui.touch ? 44. : 34.) + 10, width = menuWidth(env);
  const double x = column ? strip.right() + 4 : std::max(strip.x + 6, at->at.x);
  const double y = column ? std::max(strip.y, at->at.y) : strip.bottom() + 2;
  const app::Rect card{std::clamp(x, 0., std::max(0., ui.canvasWidth - width)),
                       std::clamp(y, 0., std::max(0., ui.canvasHeight - height)), width, height};
  beginCard(env, "picture menu", card);
  ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());  // cards of tools are there, too
  if (sides && menuRow(env, app::commandOf("side-picture"), isSide)) {
    env.sink.run(app::setSidePicture, ui.pictureMenu, isSide ? std::nullopt : std::optional(geometry::ViewFrom::Right));
  }
  if (menuRow(env, app::commandOf("rename-picture"))) env.sink.run(app::askPictureName, ui.pictureMenu);
  if (menuRow(env, app::commandOf("remove-picture"))) env.sink.run(app::removePicture, ui.pictureMenu);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const app::ClientPoint pointer{mouse.x, mouse.y};
  const bool outside = !card.contains(pointer) && !strip.contains(pointer);
  if (ImGui::IsMouseClicked(0) && outside) ui.pictureMenu = {};
  endCard();
  // A press anywhere else closes the menu and does nothing more.
  ui.overlays.push_back({0, 0, ui.canvasWidth, ui.canvasHeight});
}

}  // namespace

void drawPictureStrip(const PanelEnv& env) {
  app::UiState& ui = env.ui();
  ui.thumbnails.clear();
  const app::Rect& strip = ui.layout.pictures;
  if (strip.width < 1) return;
  const bool column = strip.height > strip.width;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {8, 8});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {8, 8});
  // The pictures themselves are drawn below the window, by the renderer.
  beginFixed("pictures", strip, ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollWithMouse);
  for (const document::PictureEntry& entry : env.document().pictures) {
    thumbnail(env, entry, column);
    if (!column) ImGui::SameLine();
  }
  commandButton(env, "open-picture", kSide);
  if (!column) ImGui::SameLine();
  commandButton(env, "new-sketch", kSide);
  dragScroll();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 low{static_cast<float>(strip.x), static_cast<float>(strip.y)};
  const ImVec2 high{static_cast<float>(strip.right()), static_cast<float>(strip.bottom())};
  list.AddLine(column ? ImVec2(high.x - 0.5f, low.y) : ImVec2(low.x, high.y - 0.5f), {high.x - 0.5f, high.y - 0.5f},
               kLine, 1);
  ImGui::End();
  ImGui::PopStyleVar(4);
  menu(env, strip);
}

}  // namespace spineloft::panels
