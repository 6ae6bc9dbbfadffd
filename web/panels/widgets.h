// The page's own widgets: flat, rounded, and large enough for a finger where a finger is used.
#pragma once

#include <imgui.h>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "web/panels/panels.h"
#include "web/platform/page.h"
#include "web/words/words.h"

namespace spineloft::panels {

/// Words of the page: English, which is shown in the visitor's language; or `asIs`, what a visitor typed or words::tr
/// gave.
struct Text {
  std::string_view words;
  bool given = false;
  Text(const char* english) : words(english) {}
  Text(std::string_view english) : words(english) {}
  Text(const std::string& english) : words(english) {}
  bool empty() const { return words.empty(); }
  /// In the language, order and form in which they are drawn; valid for this frame.
  std::string_view shown() const { return words::drawn(given ? words : words::tr(words)); }
};
inline Text asIs(std::string_view text) {
  Text out(text);
  out.given = true;
  return out;
}
inline std::string_view shown(Text text) { return text.shown(); }

/// The size of a line of shown words in a font of ours, `share` of its usual size.
ImVec2 extentOf(ImFont* font, std::string_view shown, float share = 1);
/// Draws them.
struct Line {
  ImFont* font;
  ImVec2 at;
  ImU32 colour;
  float share = 1;
};
void drawLine(ImDrawList& list, const Line& line, std::string_view shown);
/// The ground of what is on or in hand: `soft`, or a frame where no pale ground tells it.
void markOn(ImDrawList& list, ImVec2 low, ImVec2 high, ImU32 soft);

/// An icon of the font as text ("" for an unknown name). Valid until the next call.
const char* iconText(std::string_view name);

/// A window that covers `rect` and neither moves nor decorates itself.
bool beginFixed(const char* name, const app::Rect& rect, ImGuiWindowFlags extra = 0);

/// Tells the page what the last item is (UiState::controls). Whatever can be pressed says it here.
void registerControl(const PanelEnv& env, app::Control::Kind kind, std::string_view words, bool enabled = true,
                     bool on = false);

/// The control that was registered last runs this command.
void namesCommand(const PanelEnv& env, app::CommandId id);

/// A slider for a value in the unit that it shows. `changed` while a hand moves it, `done` when it has let go; both at
/// once where it is worked without a pointer.
struct Slider {
  const char* id = "";
  std::string_view words;  ///< what it sets
  float low = 0, high = 1;
  const char* format = "%.1f";  ///< may be words that hold the number
  bool logarithmic = false;
};
struct SliderTurn {
  bool changed = false, done = false;
};
SliderTurn slider(const PanelEnv& env, const Slider& what, float& value);

/// A floating card of buttons; its place is kept from the tools.
bool beginCard(const PanelEnv& env, const char* name, const app::Rect& rect);
void endCard();

/// Takes in a pointer on the panels: how long a finger stays counts by the clock of the events, however slow frames
/// are.
void watchPress(const platform::PointerEvent& event);
/// The finger that is down stays, or stayed before it moved on.
bool longPress();
/// The finger that was just lifted stayed.
bool wasLongPress();

/// What the mouse is told about the last item when it rests on it, and a finger that stays on it.
void tooltip(Text tip);

/// Text in a font of ours, in as many lines as ImGui::PushTextWrapPos leaves it, at the side where its language begins.
void label(ImFont* font, ImU32 colour, Text text);
/// Text as far as the room goes, and three dots where it goes no further; as it is drawn.
std::string_view shortened(ImFont* font, Text text, float width, float share = 1);
/// Text in one line, or else in two lines of about one length; each as `shortened`. The second may be empty.
std::array<std::string_view, 2> inTwoLines(ImFont* font, Text text, float width);
/// Words for a narrow place: smaller where they are a little too wide, then the first one, then shortened.
struct Fitted {
  std::string_view text;  ///< as it is drawn
  float share = 1;        ///< of the font's size
};
Fitted fitted(ImFont* font, Text text, float width);
/// A small bold heading.
void heading(const PanelEnv& env, Text text);

struct IconButton {
  const char* id = "";
  std::string_view icon;
  Text tip;
  bool active = false;
  bool enabled = true;
  float size = 36;
  ImU32 colour = 0;             ///< when active; 0: the accent of the page
  std::string_view words = {};  ///< what it does; empty: `tip`
  Text below = "";              ///< a word under the icon
  float width = 0;              ///< 0: as wide as high
};
bool iconButton(const PanelEnv& env, const IconButton& button);
/// The button of a command; runs it when pressed. Tools have their own colours; what else is on has `colour`, or the
/// accent of the page. With a width it says its word below the icon.
void commandButton(const PanelEnv& env, app::CommandId id, float size, float width = 0, ImU32 colour = 0);
/// How wide and how high it has to be for its word.
float commandButtonWidth(const PanelEnv& env, app::CommandId id);
float wordedHeight(const PanelEnv& env);
/// Below this height of a view they would take too much of it.
inline constexpr double kWordsFrom = 220;

/// The button of a command about what the caller names; true: it was pressed, and the caller runs it.
bool namedButton(const PanelEnv& env, app::CommandId id, float size);

/// A button with words; `primary` is the one that ends the work.
struct TextButton {
  const char* id = "";
  Text text;
  bool primary = false;
  bool enabled = true;
  float height = 36, width = 0;  ///< 0: as wide as the words need
};
bool textButton(const PanelEnv& env, const TextButton& button);
/// How wide such a button becomes by itself.
float textButtonWidth(const PanelEnv& env, Text text);

/// A button of a command that says its word, or the value that it changes; filled while the command is on.
struct CommandText {
  app::CommandId id;
  float width = 0;       ///< 0: as wide as the words need
  bool primary = false;  ///< the one that ends the work
  Text value = "";       ///< empty: the command's word
};
void commandText(const PanelEnv& env, const CommandText& button);

/// Such buttons side by side, in as many rows as they need.
class WordButtons {
 public:
  WordButtons(const PanelEnv& env, float width) : env_(env), width_(width) {}
  bool button(const char* id, Text text, bool on);

 private:
  const PanelEnv& env_;
  float width_, used_ = 0;
};

/// A button of a command that says its word beside the icon when it is wider than high; what is
/// switched on has `colour`.
struct WordButton {
  app::CommandId id;
  float width = 36, height = 36;
  ImU32 colour = 0;
};
void wordButton(const PanelEnv& env, const WordButton& button);
/// How wide it has to be for its word.
float wordButtonWidth(const PanelEnv& env, Text text, float height);

/// A tile with a drawing and, below it, a word.
struct Tile {
  const char* id = "";
  Text text = "", tip = "";
  ImVec2 size{60, 60};
  bool active = false;
  std::string_view words = {};  ///< what it does; empty: `text`, or where that is empty `tip`
  bool enabled = true;
};
/// `paint(draw list, centre, radius, colour)` fills the upper part.
using TilePaint = std::function<void(ImDrawList&, ImVec2, float, ImU32)>;
bool tile(const PanelEnv& env, const Tile& tile, const TilePaint& paint);

/// A tile that runs a command, with its icon and its word, or the first of its words where there is no room for all.
void commandTile(const PanelEnv& env, app::CommandId id, ImVec2 size);

/// One of several words in a pill.
struct Choice {
  const char* id = "";
  Text text = "";
  bool on = false;
  std::string_view said = {};  ///< to a screen reader; empty: the text
};
/// A pill of words, one of which is chosen; the one that was pressed, or none.
std::optional<std::size_t> pill(const PanelEnv& env, std::span<const Choice> choices, float width);

/// Scrolls the current window when a finger or the mouse drags its content, unless that is a slider that is moved.
void dragScroll();

/// The side of a square button: larger for fingers.
float buttonSide(const PanelEnv& env);

}  // namespace spineloft::panels
