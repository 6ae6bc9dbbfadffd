// What the shell shows of the page in the DOM, as one value: it is made anew for every frame, and told when it differs
// from what was told last. The whole state is for programs (state_json.h).
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <optional>
#include <string>

#include "engine/document/document.h"
#include "engine/image/image.h"
#include "web/edit/command_env.h"
#include "web/platform/host.h"
#include "web/ui/space.h"

namespace spineloft::app {

/// The picture in view.
struct ViewPicture {
  image::Size size;  ///< original pixels
  std::size_t strokes = 0;
  bool sketch = false, finished = false;  ///< as looksFinished
  ClientPoint topLeft, bottomRight;       ///< its corners on the canvas
  double buttons = 0;                     ///< y on the canvas where the buttons at the foot of its view begin
  /// Around the pen's lines on it, without any around the line of its first part: left, top, right, bottom, its pixels.
  /// None also while a slice is drawn in its place.
  std::optional<std::array<double, 4>> drawn;
  bool operator==(const ViewPicture&) const = default;
};

struct ViewSelected {
  PartId id;
  std::string name;
  document::PartKind kind = document::PartKind::Loft;
  std::size_t ribs = 0;
  bool operator==(const ViewSelected&) const = default;
};

struct ViewActivity {
  std::string label;
  int done = 0;  ///< of ShellView::kActivitySteps
  bool operator==(const ViewActivity&) const = default;
};

struct ShellView {
  static constexpr int kActivitySteps = 20;
  /// More than the command table has rows.
  static constexpr std::size_t kMostCommands = 320;

  std::string documentName;
  std::size_t pictures = 0, parts = 0, picked = 0;  ///< `picked`: ticked for the next solid
  std::size_t solids = 0, hollow = 0;               ///< made of parts, and those of them that are hollow
  std::size_t mirrored = 0, shaped = 0;  ///< parts with a live other side; with another section than the first
  bool turned = false, checked = false;  ///< the camera by the visitor; for printing, as the model is
  std::optional<ViewPicture> picture;
  std::optional<ViewSelected> selected;
  ToolKind tool = ToolKind::Draw;
  bool penMenu = false;  ///< a menu of the pen is open
  std::size_t undo = 0, redo = 0, historyBytes = 0, historyBudget = 0;
  bool unsaved = false;
  std::optional<ViewActivity> activity;
  /// By place in the command table. A command that is no toggle is never toggled.
  std::bitset<kMostCommands> enabled, toggled;
  bool operator==(const ShellView&) const = default;
};

/// The page as it is, in place of what `view` held: a view like the one before asks for no memory.
void viewOf(const CommandEnv& env, ShellView& view);

/// Tells the shell: {type: 'changed', view}, as ShellView of web/shell/shell_view.ts.
void sendView(platform::Host& host, const ShellView& view);

}  // namespace spineloft::app
