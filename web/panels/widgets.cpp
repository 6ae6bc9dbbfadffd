#include "web/panels/widgets.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "web/panels/theme.h"
#include "web/ui/icons.h"

namespace spineloft::panels {
namespace {

constexpr float kDragSlop = 8;

/// The first word, when the whole text is too wide.
std::string_view fitting(ImFont* font, std::string_view text, float width) {
  const float scale = ImGui::GetIO().FontGlobalScale;
  const auto widthOf = [&](std::string_view t) {
    return font->CalcTextSizeA(font->FontSize * scale, FLT_MAX, 0, t.data(), t.data() + t.size()).x;
  };
  if (widthOf(text) <= width) return text;
  return text.substr(0, std::min(text.find(' '), text.find('-')));
}

/// The same colour as a pale ground.
ImU32 softened(ImU32 colour) { return (colour & ~IM_COL32_A_MASK) | (28u << IM_COL32_A_SHIFT); }

std::string tipOf(const app::Command& command) {
  std::string tip(command.label);
  if (!command.shortcut.empty()) {
    tip += "  (" + std::string(command.shortcut.substr(0, command.shortcut.find(", "))) + ")";
  }
  return tip;
}

}  // namespace

void tooltip(std::string_view tip) {
  if (tip.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_ForTooltip)) return;
  if (ImGui::GetIO().MouseSource == ImGuiMouseSource_TouchScreen) return;
  ImGui::PushStyleColor(ImGuiCol_Text, kSurface);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {10, 7});
  if (ImGui::BeginTooltip()) {
    ImGui::TextUnformatted(tip.data(), tip.data() + tip.size());
    ImGui::EndTooltip();
  }
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
}

const char* iconText(std::string_view name) {
  static std::array<char, 4> text;
  const std::uint16_t code = app::iconCode(name);
  if (code == 0) return "";
  text = {static_cast<char>(0xe0 | (code >> 12)), static_cast<char>(0x80 | ((code >> 6) & 0x3f)),
          static_cast<char>(0x80 | (code & 0x3f)), '\0'};
  return text.data();
}

bool beginFixed(const char* name, const app::Rect& rect, ImGuiWindowFlags extra) {
  ImGui::SetNextWindowPos({static_cast<float>(rect.x), static_cast<float>(rect.y)});
  ImGui::SetNextWindowSize({static_cast<float>(rect.width), static_cast<float>(rect.height)});
  return ImGui::Begin(name, nullptr,
                      ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                          ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBringToFrontOnFocus |
                          ImGuiWindowFlags_NoFocusOnAppearing | extra);
}

void registerControl(const PanelEnv& env, app::Control::Kind kind, std::string_view words, bool enabled, bool on) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const ImVec2 middle{(low.x + high.x) / 2, (low.y + high.y) / 2};
  const bool inSight = ImGui::GetCurrentWindow()->ClipRect.Contains(middle);
  env.ui().controls.push_back(
      {kind, std::string(words), {low.x, low.y, high.x - low.x, high.y - low.y}, inSight, enabled, on});
}

bool beginCard(const PanelEnv& env, const char* name, const app::Rect& rect) {
  env.ui().overlays.push_back(rect);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {4, 4});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {2, 2});
  return beginFixed(name, rect);
}

void endCard() {
  ImGui::End();
  ImGui::PopStyleVar(3);
}

void label(ImFont* font, ImU32 colour, std::string_view text) {
  ImGui::PushFont(font);
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

std::string shortened(ImFont* font, std::string_view text, float width) {
  const float size = font->FontSize * ImGui::GetIO().FontGlobalScale;
  const auto widthOf = [&](const std::string& t) {
    return font->CalcTextSizeA(size, FLT_MAX, 0, t.data(), t.data() + t.size()).x;
  };
  std::string out(text);
  while (widthOf(out) > width && !text.empty()) {
    std::size_t end = text.size() - 1;  // a letter may be several bytes: back to its first
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
    text = text.substr(0, end);
    while (text.ends_with(' ')) text.remove_suffix(1);
    out = std::string(text) + "…";
  }
  return out;
}

void heading(const PanelEnv& env, std::string_view text) {
  ImGui::Dummy({0, 2});
  label(env.fonts.bold, kInk, text);
  ImGui::Dummy({0, 0});
}

bool iconButton(const PanelEnv& env, const IconButton& button) {
  const ImU32 own = button.colour != 0 ? button.colour : kAccent;
  ImGui::BeginDisabled(!button.enabled);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool pressed = ImGui::InvisibleButton(button.id, {button.size, button.size});
  registerControl(env, app::Control::Kind::Button, button.words.empty() ? button.tip : button.words, button.enabled,
                  button.active);
  const bool hovered = ImGui::IsItemHovered(), held = ImGui::IsItemActive();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end{at.x + button.size, at.y + button.size};
  if (button.active || hovered || held) {
    list.AddRectFilled(at, end, button.active ? softened(own) : held ? kLine : kHover, 8);
  }
  const ImU32 ink = button.active ? own : button.enabled ? kInk : rgb(0x5c6474, 110);
  ImFont* font = env.fonts.icons;
  const float size = font->FontSize * ImGui::GetIO().FontGlobalScale;
  const char* text = iconText(button.icon);
  const ImVec2 extent = font->CalcTextSizeA(size, FLT_MAX, 0, text);
  list.AddText(font, size, {at.x + (button.size - extent.x) / 2, at.y + (button.size - extent.y) / 2}, ink, text);
  ImGui::EndDisabled();
  tooltip(button.tip);
  return pressed && button.enabled;
}

void commandButton(const PanelEnv& env, app::CommandId id, float size) {
  const app::Command& command = app::commandOf(id);
  const std::string name{std::string_view(id)};
  const bool active = command.toggled != nullptr && command.toggled(env.env);
  const bool can = app::enabled(command, env.env);
  const ImU32 colour = command.group == "tool" ? toolColour(env.ui().tool) : 0;
  const std::string tip = tipOf(command);
  if (iconButton(env, {name.c_str(), command.icon, tip, active, can, size, colour, command.label})) {
    env.sink.run(command);
  }
}

bool namedButton(const PanelEnv& env, app::CommandId id, float size) {
  const app::Command& command = app::commandOf(id);
  const std::string name{std::string_view(id)}, tip = tipOf(command);
  return iconButton(env, {name.c_str(), command.icon, tip, false, true, size, 0, command.label});
}

float wordButtonWidth(const PanelEnv& env, std::string_view text, float height) {
  const float size = env.fonts.small->FontSize * ImGui::GetIO().FontGlobalScale;
  return height + env.fonts.small->CalcTextSizeA(size, FLT_MAX, 0, text.data(), text.data() + text.size()).x + 8;
}

void wordButton(const PanelEnv& env, const WordButton& button) {
  const app::Command& command = app::commandOf(button.id);
  const bool active = command.toggled != nullptr && command.toggled(env.env);
  const bool can = app::enabled(command, env.env);
  ImGui::BeginDisabled(!can);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool pressed =
      ImGui::InvisibleButton(std::string(std::string_view(button.id)).c_str(), {button.width, button.height});
  registerControl(env, app::Control::Kind::Button, command.label, can, active);
  const bool hovered = ImGui::IsItemHovered(), held = ImGui::IsItemActive();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end{at.x + button.width, at.y + button.height};
  if (active || hovered || held) {
    list.AddRectFilled(at, end, active ? softened(button.colour) : held ? kLine : kHover, 8);
  }
  const ImU32 ink = active ? button.colour : can ? kInk : rgb(0x5c6474, 110);
  ImFont* icons = env.fonts.icons;
  const float scale = ImGui::GetIO().FontGlobalScale, size = icons->FontSize * scale;
  const char* text = iconText(command.icon);
  const ImVec2 extent = icons->CalcTextSizeA(size, FLT_MAX, 0, text);
  list.AddText(icons, size, {at.x + (button.height - extent.x) / 2, at.y + (button.height - extent.y) / 2}, ink, text);
  if (button.width > button.height + 8) {
    ImFont* font = env.fonts.small;
    const float height = font->FontSize * scale;
    const std::string_view label = command.label;
    list.AddText(font, height, {at.x + button.height - 4, at.y + (button.height - height) / 2}, ink, label.data(),
                 label.data() + label.size());
  }
  ImGui::EndDisabled();
  tooltip(button.width > button.height + 8 ? command.hint : std::string_view(tipOf(command)));
  if (pressed && can) env.sink.run(command);
}

float textButtonWidth(const PanelEnv& env, std::string_view text) {
  const float size = env.fonts.text->FontSize * ImGui::GetIO().FontGlobalScale;
  return env.fonts.text->CalcTextSizeA(size, FLT_MAX, 0, text.data(), text.data() + text.size()).x + 24;
}

bool textButton(const PanelEnv& env, const TextButton& button) {
  ImGui::BeginDisabled(!button.enabled);
  const float width = button.width > 0 ? button.width : textButtonWidth(env, button.text);
  const ImVec2 at = ImGui::GetCursorScreenPos(), end{at.x + width, at.y + button.height};
  const bool pressed = ImGui::InvisibleButton(button.id, {width, button.height});
  registerControl(env, app::Control::Kind::Button, button.text, button.enabled, button.primary);
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 plain = hovered ? kHover : rgb(0xfaf9f6);
  list.AddRectFilled(at, end, button.primary ? kAccent : plain, 8);
  if (!button.primary) list.AddRect(at, end, hovered ? kMuted : kLine, 8);
  ImFont* font = button.primary ? env.fonts.bold : env.fonts.text;
  const float size = font->FontSize * ImGui::GetIO().FontGlobalScale;
  const char* from = button.text.data();
  const ImVec2 extent = font->CalcTextSizeA(size, FLT_MAX, 0, from, from + button.text.size());
  const ImU32 ink = !button.enabled ? rgb(0x5c6474, 110) : button.primary ? kSurface : kInk;
  list.AddText(font, size, {at.x + (width - extent.x) / 2, at.y + (button.height - extent.y) / 2}, ink, from,
               from + button.text.size());
  ImGui::EndDisabled();
  return pressed && button.enabled;
}

void commandText(const PanelEnv& env, const CommandText& button) {
  const app::Command& command = app::commandOf(button.id);
  const std::string name{std::string_view(button.id)};
  const bool on = command.toggled != nullptr && command.toggled(env.env);
  const std::string_view text = button.value.empty() ? command.label : button.value;
  const bool pressed = textButton(
      env, {name.c_str(), text, on || button.primary, app::enabled(command, env.env), buttonSide(env), button.width});
  tooltip(command.hint);
  if (pressed) env.sink.run(command);
}

bool WordButtons::button(const char* id, std::string_view text, bool on) {
  constexpr float kGap = 4;
  const float need = textButtonWidth(env_, text);
  const bool fits = used_ > 0 && used_ + kGap + need <= width_;
  if (fits) ImGui::SameLine(0, kGap);
  used_ = fits ? used_ + kGap + need : need;
  return textButton(env_, {id, text, on, true, buttonSide(env_), need});
}

bool tile(const PanelEnv& env, const Tile& tile, const TilePaint& paint) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool pressed = ImGui::InvisibleButton(tile.id, tile.size);
  const std::string_view shown = tile.text.empty() ? tile.tip : tile.text;
  registerControl(env, app::Control::Kind::Button, tile.words.empty() ? shown : tile.words, tile.enabled, tile.active);
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end{at.x + tile.size.x, at.y + tile.size.y};
  list.AddRectFilled(at, end, tile.active ? kAccentSoft : hovered ? kHover : rgb(0xfaf9f6), 8);
  list.AddRect({at.x + 0.5f, at.y + 0.5f}, {end.x - 0.5f, end.y - 0.5f}, tile.active ? kAccent : kLine, 8, 0,
               tile.active ? 1.6f : 1.f);
  const ImU32 ink = tile.active ? kAccent : kInk;
  const float textHeight = tile.text.empty() ? 0 : 15.f;
  const float room = tile.size.y - textHeight;
  const float radius = std::min(tile.size.x, room) * 0.5f - (tile.text.empty() ? 8.f : 7.f);
  paint(list, {at.x + tile.size.x / 2, at.y + room / 2 + (tile.text.empty() ? 0.f : 1.f)},
        std::max(6.f, std::min(radius, 19.f)), ink);
  if (!tile.text.empty()) {
    ImFont* font = env.fonts.small;
    const float size = font->FontSize * ImGui::GetIO().FontGlobalScale * 0.92f;
    const std::string_view text = fitting(font, tile.text, tile.size.x - 4);
    const ImVec2 extent = font->CalcTextSizeA(size, FLT_MAX, 0, text.data(), text.data() + text.size());
    list.AddText(font, size, {std::round(at.x + (tile.size.x - extent.x) / 2), end.y - extent.y - 4},
                 tile.active ? kAccent : kMuted, text.data(), text.data() + text.size());
  }
  tooltip(tile.tip);
  return pressed;
}

void commandTile(const PanelEnv& env, app::CommandId id, ImVec2 size) {
  const app::Command& command = app::commandOf(id);
  const std::string name{std::string_view(id)};
  const bool on = command.toggled != nullptr && command.toggled(env.env);
  const std::string_view below = size.y < 50 ? std::string_view() : command.label;
  const bool can = app::enabled(command, env.env);
  const bool pressed = tile(env, {name.c_str(), below, command.hint, size, on, command.label, can},
                            [&](ImDrawList& list, ImVec2 c, float, ImU32) {
                              const char* icon = iconText(command.icon);
                              ImFont* font = env.fonts.icons;
                              const float side = font->FontSize * ImGui::GetIO().FontGlobalScale;
                              const ImVec2 extent = font->CalcTextSizeA(side, FLT_MAX, 0, icon);
                              list.AddText(font, side, {c.x - extent.x / 2, c.y - extent.y / 2}, kAccent, icon);
                            });
  if (pressed && can) env.sink.run(command);
}

void dragScroll() {
  const ImGuiIO& io = ImGui::GetIO();
  if (!ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows | ImGuiHoveredFlags_AllowWhenBlockedByActiveItem)) {
    return;
  }
  if (!ImGui::IsMouseDragging(0, kDragSlop)) return;
  if (ImGui::GetScrollMaxX() <= 0 && ImGui::GetScrollMaxY() <= 0) return;
  ImGui::ClearActiveID();  // it has become a drag: no button is pressed at its end
  ImGui::SetScrollX(ImGui::GetScrollX() - io.MouseDelta.x);
  ImGui::SetScrollY(ImGui::GetScrollY() - io.MouseDelta.y);
}

float buttonSide(const PanelEnv& env) { return env.ui().touch ? 44.f : 36.f; }

}  // namespace spineloft::panels
