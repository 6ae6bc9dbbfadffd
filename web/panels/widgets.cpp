#include "web/panels/widgets.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "web/panels/theme.h"
#include "web/ui/icons.h"
#include "web/ui/press.h"

namespace spineloft::panels {
namespace {

constexpr float kDragSlop = 8;
constexpr float kWordHeight = 17;  // what a word below an icon takes
constexpr float kBelowWord = 3;
constexpr double kTipRoom = 60;  // above a button, for the words about it

/// Where a line of this width begins: at the right side of its room where the language does.
float lineStart(float left, float room, float width) {
  return words::language().rightToLeft ? left + std::max(0.f, room - width) : left;
}

/// Broken at spaces, in the order of reading.
std::vector<std::string> linesOf(ImFont* font, std::string_view text, float room) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string word(text.substr(0, end));
    const std::string longer = lines.empty() ? word : lines.back() + " " + word;
    if (lines.empty() || extentOf(font, words::drawn(longer)).x > room) {
      lines.push_back(word);
    } else {
      lines.back() = longer;
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

void rightToLeftLines(ImFont* font, std::string_view text, float room) {
  for (const std::string& line : linesOf(font, text, room)) {
    const std::string_view drawn = words::drawn(line);
    const ImVec2 at = ImGui::GetCursorScreenPos(), extent = extentOf(font, drawn);
    drawLine(*ImGui::GetWindowDrawList(),
             {font, {lineStart(at.x, room, extent.x), at.y}, ImGui::GetColorU32(ImGuiCol_Text)}, drawn);
    ImGui::Dummy({std::min(room, extent.x), extent.y});
  }
}

/// ImGui breaks lines after every point and comma, also within a number.
bool hasDecimals(std::string_view text) {
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    if ((text[i] == '.' || text[i] == ',') && isDigit(text[i - 1]) && isDigit(text[i + 1])) return true;
  }
  return false;
}

struct ButtonGround {
  ImU32 colour;
  bool active, hovered, held;
};
/// The colour as ink on a panel: a dark one half way to white where panels are dark.
ImU32 asInk(ImU32 colour) {
  if (tellsByFrames()) return kAccent;
  const ImVec4 c = ImGui::ColorConvertU32ToFloat4(colour), ground = ImGui::ColorConvertU32ToFloat4(kSurface);
  constexpr float kDarkest = 0.4f;
  const float light = 0.3f * c.x + 0.6f * c.y + 0.1f * c.z;
  if (ground.y > 0.5f || light > kDarkest) return colour;
  return ImGui::ColorConvertFloat4ToU32({(1 + c.x) / 2, (1 + c.y) / 2, (1 + c.z) / 2, c.w});
}

/// The ground of a button: of one that is on a pale one of its colour.
void buttonGround(ImDrawList& list, const ImVec2& low, const ImVec2& high, const ButtonGround& is) {
  if (is.active) {
    markOn(list, low, high, faded(is.colour, 28));
  } else if (is.hovered || is.held) {
    list.AddRectFilled(low, high, is.held ? kLine : kHover, 8);
  }
}

std::string tipOf(const app::Command& command) {
  std::string tip(words::tr(command.label));
  if (!command.shortcut.empty()) {
    tip += "  (" + std::string(command.shortcut.substr(0, command.shortcut.find(", "))) + ")";
  }
  return tip;
}

}  // namespace

ImVec2 extentOf(ImFont* font, std::string_view text, float share) {
  const float size = font->FontSize * ImGui::GetIO().FontGlobalScale * share;
  return font->CalcTextSizeA(size, FLT_MAX, 0, text.data(), text.data() + text.size());
}

void markOn(ImDrawList& list, ImVec2 low, ImVec2 high, ImU32 soft) {
  if (tellsByFrames()) {
    list.AddRect({low.x + 1, low.y + 1}, {high.x - 1, high.y - 1}, kAccent, 8, 0, 2);
  } else {
    list.AddRectFilled(low, high, soft, 8);
  }
}

void drawLine(ImDrawList& list, const Line& line, std::string_view text) {
  const float size = line.font->FontSize * ImGui::GetIO().FontGlobalScale * line.share;
  list.AddText(line.font, size, line.at, line.colour, text.data(), text.data() + text.size());
}

namespace {

/// The last press on the panels.
struct Press {
  bool finger = false;
  double x = 0, y = 0, downMs = 0;
  std::optional<double> stillMs;  ///< when it moved on or was lifted
};
Press press;

bool byFinger() { return ImGui::GetIO().MouseSource == ImGuiMouseSource_TouchScreen; }

/// The slider that was pressed. A mouse and a pen have it; a finger has it once it goes along it rather than across it,
/// which scrolls the panel. Until then it stays as it is.
struct HeldSlider {
  ImGuiID id = 0;
  bool isSure = false;
  float pressed = 0;  ///< its value where the finger is
};
HeldSlider heldSlider;

/// Call after the slider.
void holdSlider(float before, float& value, SliderTurn& turn) {
  HeldSlider& held = heldSlider;
  if (ImGui::IsItemActivated()) held = {ImGui::GetItemID(), !byFinger(), value};
  if (held.id != ImGui::GetItemID()) return;
  const ImVec2 way = ImGui::GetMouseDragDelta(0, kDragSlop);
  if (std::abs(way.x) > std::abs(way.y)) held.isSure = true;
  if (turn.done) {
    if (!held.isSure) value = held.pressed;  // a tap
  } else if (!held.isSure && ImGui::IsItemActive()) {
    held.pressed = std::exchange(value, before);
    turn.changed = false;
  }
  if (!ImGui::IsItemActive()) held = {};
}

/// The text of a slider, in the middle of it, or as near to that as the grip leaves room. Call after the slider.
void besideGrip(const Slider& what, float value, const char* text) {
  constexpr float kGap = 6;
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax(), size = ImGui::CalcTextSize(text);
  const auto share = [&](float v) {
    return what.logarithmic ? std::log(v / what.low) / std::log(what.high / what.low)
                            : (v - what.low) / (what.high - what.low);
  };
  const float grip = ImGui::GetStyle().GrabMinSize, way = high.x - low.x - grip - 4;
  const float from = low.x + 2 + way * std::clamp(share(value), 0.f, 1.f), middle = (low.x + high.x - size.x) / 2;
  const float left = from - kGap - size.x, right = from + grip + kGap;
  float x = middle;
  if (middle < right && middle + size.x > from - kGap) {
    const bool fitsLeft = left >= low.x + kGap, fitsRight = right + size.x <= high.x - kGap;
    const bool isLeft = fitsLeft && (!fitsRight || middle - left <= right - middle);
    if (fitsLeft || fitsRight) x = isLeft ? left : right;
  }
  ImGui::GetWindowDrawList()->AddText({x, (low.y + high.y - size.y) / 2}, ImGui::GetColorU32(ImGuiCol_Text), text);
}

/// A button without a look of its own. A finger that stayed on it asked for its name and presses nothing.
bool pressedItem(const char* id, ImVec2 size) { return ImGui::InvisibleButton(id, size) && !wasLongPress(); }

}  // namespace

void watchPress(const platform::PointerEvent& event) {
  if (event.kind == platform::PointerKind::Down) {
    press = {event.device == platform::Device::Touch, event.x, event.y, event.timeMs, {}};
  }
  const bool moves = event.kind == platform::PointerKind::Move;
  if (press.stillMs || (moves && std::hypot(event.x - press.x, event.y - press.y) < kDragSlop)) return;
  if (event.kind != platform::PointerKind::Down) press.stillMs = event.timeMs;
}

bool longPress() {
  if (press.stillMs) return press.finger && *press.stillMs - press.downMs >= app::kLongPressMs;
  return press.finger && ImGui::GetIO().MouseDownDuration[0] >= app::kLongPressMs / 1000;
}

bool wasLongPress() { return press.stillMs && longPress(); }

void tooltip(Text tip) {
  const bool stays = ImGui::IsItemActive() && longPress();
  const bool rests = !byFinger() && ImGui::IsItemHovered(ImGuiHoveredFlags_ForTooltip);
  if (tip.empty() || !(stays || rests)) return;
  if (stays) {  // beside the finger, not under it
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const bool above = low.y > kTipRoom;
    ImGui::SetNextWindowPos({(low.x + high.x) / 2, above ? low.y - 8 : high.y + 8}, ImGuiCond_Always,
                            {0.5f, above ? 1.f : 0.f});
  }
  ImGui::PushStyleColor(ImGuiCol_Text, kOnBubble);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {10, 7});
  if (ImGui::BeginTooltip()) {
    const std::string_view text = tip.shown();
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
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
  app::UiState& ui = env.ui();
  const std::uint32_t id = ImGui::GetItemID();
  ui.controls.push_back(
      {kind, std::string(words), {low.x, low.y, high.x - low.x, high.y - low.y}, inSight, enabled, on, id});
  if (ui.wantedInSight == 0 || ui.wantedInSight != id) return;
  ui.wantedInSight = 0;
  if (!inSight) ImGui::ScrollToItem(ImGuiScrollFlags_KeepVisibleCenterY | ImGuiScrollFlags_KeepVisibleEdgeX);
}

void namesCommand(const PanelEnv& env, app::CommandId id) { env.ui().controls.back().command = id; }

SliderTurn slider(const PanelEnv& env, const Slider& what, float& value) {
  SliderTurn turn;
  const float before = value;
  const bool isTyped = ImGui::TempInputIsActive(ImGui::GetID(what.id));
  if (!isTyped) ImGui::PushStyleColor(ImGuiCol_Text, 0);  // its text stands beside the grip, not over it
  turn.changed = ImGui::SliderFloat(what.id, &value, what.low, what.high, what.format,
                                    what.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
  if (!isTyped) ImGui::PopStyleColor();
  turn.done = ImGui::IsItemDeactivatedAfterEdit();
  holdSlider(before, value, turn);
  registerControl(env, app::Control::Kind::Slider, what.words);
  app::Control& control = env.ui().controls.back();
  std::optional<app::AskedControl>& asked = env.ui().asked;
  if (asked && asked->value && asked->id == control.id) {
    value = std::clamp(static_cast<float>(*asked->value), what.low, what.high);
    asked.reset();
    turn = {true, true};
  }
  std::array<char, 80> text{};
  ImFormatString(text.data(), text.size(), what.format, static_cast<double>(value));
  control.slide = {static_cast<double>(what.low), static_cast<double>(what.high), static_cast<double>(value),
                   text.data()};
  if (!isTyped) besideGrip(what, value, text.data());
  return turn;
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

void label(ImFont* font, ImU32 colour, Text what) {
  const std::string_view text = what.given ? what.words : words::tr(what.words);
  ImGui::PushFont(font);
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  const float wrap = ImGui::GetCurrentWindow()->DC.TextWrapPos;
  const float room = wrap > 0 ? wrap - ImGui::GetCursorPosX() : ImGui::GetContentRegionAvail().x;
  if (words::language().rightToLeft) {
    rightToLeftLines(font, text, room);
  } else if (wrap >= 0 && hasDecimals(text)) {
    std::string all;
    for (const std::string& line : linesOf(font, text, room)) all += (all.empty() ? "" : "\n") + line;
    ImGui::TextUnformatted(all.data(), all.data() + all.size());
  } else {
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
  }
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

std::string_view shortened(ImFont* font, Text what, float width, float share) {
  std::string_view text = what.given ? what.words : words::tr(what.words);
  if (const std::string_view all = words::drawn(text); extentOf(font, all, share).x <= width) return all;
  std::string out(text);
  while (extentOf(font, words::drawn(out), share).x > width && !text.empty()) {
    std::size_t end = text.size() - 1;  // a letter may be several bytes: back to its first
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
    text = text.substr(0, end);
    while (text.ends_with(' ')) text.remove_suffix(1);
    out = std::string(text) + "…";
  }
  return words::kept(std::string(words::drawn(out)));
}

std::array<std::string_view, 2> inTwoLines(ImFont* font, Text what, float width) {
  const std::string_view text = what.given ? what.words : words::tr(what.words);
  const auto widthOf = [&](std::string_view part) { return extentOf(font, words::drawn(part)).x; };
  if (widthOf(text) <= width) return {words::drawn(text), {}};
  std::size_t best = std::string_view::npos;
  float least = INFINITY;
  for (std::size_t at = text.find(' '); at != std::string_view::npos; at = text.find(' ', at + 1)) {
    const float wider = std::max(widthOf(text.substr(0, at)), widthOf(text.substr(at + 1)));
    if (wider < least) std::tie(best, least) = std::pair(at, wider);
  }
  if (best == std::string_view::npos) return {shortened(font, what, width), {}};
  return {shortened(font, asIs(text.substr(0, best)), width), shortened(font, asIs(text.substr(best + 1)), width)};
}

Fitted fitted(ImFont* font, Text what, float width) {
  // Rather smaller than fewer words, but no smaller than the smallest words of the DOM.
  constexpr float kLeastEm = 11;
  const float em = app::kTextEm * font->FontSize / ImGui::GetIO().FontDefault->FontSize;
  const float least = std::min(1.f, kLeastEm / em);
  const auto widthOf = [&](std::string_view text) { return extentOf(font, words::drawn(text)).x; };
  std::string_view text = what.given ? what.words : words::tr(what.words);
  if (widthOf(text) * least > width) text = text.substr(0, text.find_first_of(" -", 1));
  const float wide = widthOf(text), scale = wide > width ? std::max(least, width / wide) : 1;
  if (wide * least <= width) return {words::drawn(text), scale};
  return {shortened(font, asIs(text), width, scale), scale};
}

void heading(const PanelEnv& env, Text text) {
  ImGui::Dummy({0, 2});
  label(env.fonts.bold, kInk, text);
  ImGui::Dummy({0, 0});
}

namespace {

/// A word in the middle of `width`, below an icon.
void wordBelow(const PanelEnv& env, ImDrawList& list, Text text, ImVec2 at, float width, ImU32 colour) {
  ImFont* font = env.fonts.small;
  const Fitted below = fitted(font, text, width - 2);
  const ImVec2 extent = extentOf(font, below.text, below.share);
  const ImVec2 pen{std::round(at.x + (width - extent.x) / 2), at.y + kWordHeight - extent.y};
  drawLine(list, {font, pen, colour, below.share}, below.text);
}

}  // namespace

bool iconButton(const PanelEnv& env, const IconButton& button) {
  const ImU32 own = button.colour != 0 ? button.colour : kAccent;
  ImGui::BeginDisabled(!button.enabled);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 extentOfAll{button.width > 0 ? button.width : button.size, button.size};
  const bool pressed = pressedItem(button.id, extentOfAll);
  registerControl(env, app::Control::Kind::Button, button.words.empty() ? button.tip.words : button.words,
                  button.enabled, button.active);
  const bool hovered = ImGui::IsItemHovered(), held = ImGui::IsItemActive();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end{at.x + extentOfAll.x, at.y + extentOfAll.y};
  buttonGround(list, at, end, {own, button.active, hovered, held});
  const ImU32 ink = button.active ? asInk(own) : button.enabled ? kInk : kDisabled;
  ImFont* font = env.fonts.icons;
  const float size = font->FontSize * ImGui::GetIO().FontGlobalScale;
  const char* text = iconText(button.icon);
  const ImVec2 extent = font->CalcTextSizeA(size, FLT_MAX, 0, text);
  const float room = button.below.empty() ? button.size : button.size - kWordHeight - kBelowWord;
  list.AddText(font, size, {at.x + (extentOfAll.x - extent.x) / 2, at.y + (room - extent.y) / 2}, ink, text);
  if (!button.below.empty()) wordBelow(env, list, button.below, {at.x, at.y + room}, extentOfAll.x, ink);
  ImGui::EndDisabled();
  tooltip(button.tip);
  return pressed && button.enabled;
}

float commandButtonWidth(const PanelEnv& env, app::CommandId id) {
  constexpr float kLeast = 44, kMost = 104;
  return std::clamp(extentOf(env.fonts.small, shown(app::commandOf(id).label)).x + 8, kLeast, kMost);
}

float wordedHeight(const PanelEnv& env) { return env.ui().touch ? 51.f : 48.f; }

void commandButton(const PanelEnv& env, app::CommandId id, float size, float width, ImU32 colour) {
  const app::Command& command = app::commandOf(id);
  const std::string name{std::string_view(id)};
  const bool active = command.toggled != nullptr && command.toggled(env.env);
  const bool can = app::enabled(command, env.env);
  const ImU32 own = command.group == "tool" ? toolColour(env.ui().tool) : colour;
  const std::string tip = tipOf(command);
  const Text below = width > 0 ? Text(command.label) : Text("");
  const bool pressed =
      iconButton(env, {name.c_str(), command.icon, asIs(tip), active, can, size, own, command.label, below, width});
  namesCommand(env, id);
  if (pressed) env.sink.run(command);
}

bool namedButton(const PanelEnv& env, app::CommandId id, float size) {
  const app::Command& command = app::commandOf(id);
  const std::string name{std::string_view(id)}, tip = tipOf(command);
  const bool pressed = iconButton(env, {name.c_str(), command.icon, asIs(tip), false, true, size, 0, command.label});
  namesCommand(env, id);
  return pressed;
}

float wordButtonWidth(const PanelEnv& env, Text text, float height) {
  return height + extentOf(env.fonts.small, text.shown()).x + 8;
}

void wordButton(const PanelEnv& env, const WordButton& button) {
  const app::Command& command = app::commandOf(button.id);
  const bool active = command.toggled != nullptr && command.toggled(env.env);
  const bool can = app::enabled(command, env.env);
  ImGui::BeginDisabled(!can);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool pressed = pressedItem(std::string(std::string_view(button.id)).c_str(), {button.width, button.height});
  registerControl(env, app::Control::Kind::Button, command.label, can, active);
  namesCommand(env, button.id);
  const bool hovered = ImGui::IsItemHovered(), held = ImGui::IsItemActive();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end{at.x + button.width, at.y + button.height};
  buttonGround(list, at, end, {button.colour, active, hovered, held});
  const ImU32 ink = active ? asInk(button.colour) : can ? kInk : kDisabled;
  ImFont* icons = env.fonts.icons;
  const float scale = ImGui::GetIO().FontGlobalScale, size = icons->FontSize * scale;
  const char* text = iconText(command.icon);
  const ImVec2 extent = icons->CalcTextSizeA(size, FLT_MAX, 0, text);
  list.AddText(icons, size, {at.x + (button.height - extent.x) / 2, at.y + (button.height - extent.y) / 2}, ink, text);
  if (button.width > button.height + 8) {
    ImFont* font = env.fonts.small;
    const float height = font->FontSize * scale;
    const std::string_view label = shortened(font, command.label, button.width - button.height - 2);
    drawLine(list, {font, {at.x + button.height - 4, at.y + (button.height - height) / 2}, ink}, label);
  }
  ImGui::EndDisabled();
  tooltip(button.width > button.height + 8 ? asIs(words::tr(command.hint)) : asIs(tipOf(command)));
  if (pressed && can) env.sink.run(command);
}

float textButtonWidth(const PanelEnv& env, Text text) { return extentOf(env.fonts.text, text.shown()).x + 24; }

bool textButton(const PanelEnv& env, const TextButton& button) {
  ImGui::BeginDisabled(!button.enabled);
  const float width = button.width > 0 ? button.width : textButtonWidth(env, button.text);
  const ImVec2 at = ImGui::GetCursorScreenPos(), end{at.x + width, at.y + button.height};
  const bool pressed = pressedItem(button.id, {width, button.height});
  registerControl(env, app::Control::Kind::Button, button.text.words, button.enabled, button.primary);
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 plain = hovered ? kHover : kTile;
  list.AddRectFilled(at, end, button.primary ? kAccent : plain, 8);
  if (!button.primary) list.AddRect(at, end, hovered ? kMuted : kLine, 8);
  ImFont* font = button.primary ? env.fonts.bold : env.fonts.text;
  const std::string_view text = shortened(font, button.text, width - 8);
  const ImVec2 extent = extentOf(font, text);
  const ImU32 ink = !button.enabled ? kDisabled : button.primary ? kOnAccent : kInk;
  drawLine(list, {font, {at.x + (width - extent.x) / 2, at.y + (button.height - extent.y) / 2}, ink}, text);
  ImGui::EndDisabled();
  return pressed && button.enabled;
}

void commandText(const PanelEnv& env, const CommandText& button) {
  const app::Command& command = app::commandOf(button.id);
  const std::string name{std::string_view(button.id)};
  const bool on = command.toggled != nullptr && command.toggled(env.env);
  const Text text = button.value.empty() ? Text(command.label) : button.value;
  const bool pressed = textButton(
      env, {name.c_str(), text, on || button.primary, app::enabled(command, env.env), buttonSide(env), button.width});
  namesCommand(env, button.id);
  tooltip(command.hint);
  if (pressed) env.sink.run(command);
}

bool WordButtons::button(const char* id, Text text, bool on) {
  constexpr float kGap = 4;
  const float need = textButtonWidth(env_, text);
  const bool fits = used_ > 0 && used_ + kGap + need <= width_;
  if (fits) ImGui::SameLine(0, kGap);
  used_ = fits ? used_ + kGap + need : need;
  return textButton(env_, {id, text, on, true, buttonSide(env_), need});
}

bool tile(const PanelEnv& env, const Tile& tile, const TilePaint& paint) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool pressed = pressedItem(tile.id, tile.size);
  const std::string_view says = tile.text.empty() ? tile.tip.words : tile.text.words;
  registerControl(env, app::Control::Kind::Button, tile.words.empty() ? says : tile.words, tile.enabled, tile.active);
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end{at.x + tile.size.x, at.y + tile.size.y};
  list.AddRectFilled(at, end, tile.active ? kAccentSoft : hovered ? kHover : kTile, 8);
  list.AddRect({at.x + 0.5f, at.y + 0.5f}, {end.x - 0.5f, end.y - 0.5f}, tile.active ? kAccent : kLine, 8, 0,
               tile.active ? 1.6f : 1.f);
  const ImU32 ink = tile.active ? kAccent : kInk;
  const float textHeight = tile.text.empty() ? 0 : kWordHeight;
  const float room = tile.size.y - textHeight;
  const float radius = std::min(tile.size.x, room) * 0.5f - (tile.text.empty() ? 8.f : 7.f);
  paint(list, {at.x + tile.size.x / 2, at.y + room / 2 + (tile.text.empty() ? 0.f : 1.f)},
        std::max(6.f, std::min(radius, 19.f)), ink);
  if (!tile.text.empty()) {
    wordBelow(env, list, tile.text, {at.x, end.y - kBelowWord - kWordHeight}, tile.size.x,
              tile.active ? kAccent : kMuted);
  }
  tooltip(tile.tip);
  return pressed;
}

void commandTile(const PanelEnv& env, app::CommandId id, ImVec2 size) {
  const app::Command& command = app::commandOf(id);
  const std::string name{std::string_view(id)};
  const bool on = command.toggled != nullptr && command.toggled(env.env);
  const Text below = size.y < 50 ? Text("") : Text(command.label);
  const bool can = app::enabled(command, env.env);
  const bool pressed = tile(env, {name.c_str(), below, command.hint, size, on, command.label, can},
                            [&](ImDrawList& list, ImVec2 c, float, ImU32) {
                              const char* icon = iconText(command.icon);
                              ImFont* font = env.fonts.icons;
                              const float side = font->FontSize * ImGui::GetIO().FontGlobalScale;
                              const ImVec2 extent = font->CalcTextSizeA(side, FLT_MAX, 0, icon);
                              list.AddText(font, side, {c.x - extent.x / 2, c.y - extent.y / 2}, kAccent, icon);
                            });
  namesCommand(env, id);
  if (pressed && can) env.sink.run(command);
}

void dragScroll() {
  const ImGuiIO& io = ImGui::GetIO();
  if (!ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows | ImGuiHoveredFlags_AllowWhenBlockedByActiveItem)) {
    return;
  }
  if (!ImGui::IsMouseDragging(0, kDragSlop)) return;
  if (heldSlider.isSure && heldSlider.id == ImGui::GetActiveID()) return;
  if (ImGui::GetScrollMaxX() <= 0 && ImGui::GetScrollMaxY() <= 0) return;
  ImGui::ClearActiveID();  // it has become a drag: no button is pressed at its end
  ImGui::SetScrollX(ImGui::GetScrollX() - io.MouseDelta.x);
  ImGui::SetScrollY(ImGui::GetScrollY() - io.MouseDelta.y);
}

float buttonSide(const PanelEnv& env) { return env.ui().touch ? 44.f : 36.f; }

std::optional<std::size_t> pill(const PanelEnv& env, std::span<const Choice> choices, float width) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = env.ui().touch ? 44.f : 36.f;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + width, at.y + height}, kTrough, kRadius);
  const float each = width / static_cast<float>(choices.size());
  std::optional<std::size_t> pressed;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (i > 0) ImGui::SameLine(0, 0);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton(choices[i].id, {each, height}) && !choices[i].on) pressed = i;
    const std::string_view said = choices[i].said.empty() ? choices[i].text.words : choices[i].said;
    registerControl(env, app::Control::Kind::Button, said, true, choices[i].on);
    const ImVec2 low{corner.x + 3, corner.y + 3}, high{corner.x + each - 3, corner.y + height - 3};
    if (choices[i].on) {
      list.AddRectFilled(low, high, kSurface, kRadius - 2);
      list.AddRect(low, high, kLine, kRadius - 2);
    }
    ImFont* font = choices[i].on ? env.fonts.bold : env.fonts.text;
    const Fitted word = fitted(font, choices[i].text, each - 8);
    const ImVec2 extent = extentOf(font, word.text, word.share);
    drawLine(list,
             {font,
              {corner.x + (each - extent.x) / 2, corner.y + (height - extent.y) / 2},
              choices[i].on ? kAccent : kMuted,
              word.share},
             word.text);
  }
  return pressed;
}

}  // namespace spineloft::panels
