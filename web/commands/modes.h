// Modes: what is open above the model, such as the board for a slice, a menu or the gesture in hand. They lie in one
// fixed order. Escape, undo, redo and keys go to the topmost open mode that takes them.
#pragma once

#include <algorithm>
#include <span>
#include <string_view>

#include "web/commands/commands.h"

namespace spineloft::app {

/// A mode is open while the state that it is about is there (a draft, a menu, a chosen point): nothing else keeps it.
/// Its keys are the shortcuts of the commands whose `Command::mode` it is.
struct Mode {
  std::string_view name;
  bool (*open)(const CommandEnv&);
  void (*cancel)(const CommandEnv&) = nullptr;  ///< what Escape does; null: Escape is for the next mode
  /// Its own steps, all that undo and redo reach while it is open; null: they are for the next mode.
  Run *undo = nullptr, *redo = nullptr;
  bool (*canUndo)(const CommandEnv&) = nullptr, (*canRedo)(const CommandEnv&) = nullptr;
};

/// All of them, the topmost first; the last one, the model, is always open and takes everything.
std::span<const Mode* const> modes();
/// The topmost open mode that has this, such as `&Mode::cancel`.
template <class Function>
const Mode& topMode(const CommandEnv& env, Function* Mode::* has) {
  return **std::ranges::find_if(modes(), [&](const Mode* mode) { return mode->*has && mode->open(env); });
}

extern const Mode kBoardMode;         ///< a slice is drawn on the board: section_board_commands.cpp
extern const Mode kCutMode;           ///< a thing is cut out of the picture: cut_commands.cpp
extern const Mode kHollowMode;        ///< what would become hollow is shown: hollow_commands.cpp
extern const Mode kRibMode;           ///< a rib is chosen, for the tool of ribs: rib_commands.cpp
extern const Mode kPointMode;         ///< a rib or a point of the spine is chosen: spine_commands.cpp
extern const Mode kOutlinePointMode;  ///< a point of an outline is chosen: outline_commands.cpp
extern const Mode kOutlineMode;       ///< a part that has an outline is selected for its tool: the same
extern const Mode kBoneMode;          ///< a point of the bones of a puff is chosen: puff_bone_commands.cpp
extern const Mode kBonesMode;         ///< they are shown: the same
extern const Mode kShapePointMode;    ///< a handle of a shape is chosen: shape_tool_commands.cpp
extern const Mode kShapeMode;         ///< they are shown: the same
extern const Mode kCrossingMode;      ///< a crossing of a line drawing is chosen: line_commands.cpp
extern const Mode kLinesMode;         ///< its tool is in hand: the same
extern const Mode kPullMode;          ///< a pull is chosen: pull_commands.cpp
extern const Mode kPullToolMode;      ///< its tool is in hand: the same
extern const Mode kBridgeToolMode;    ///< the tool for bridges between parts is in hand: bridge_commands.cpp
extern const Mode kRailMode;          ///< the next line is the rail of layers: layer_commands.cpp
extern const Mode kLayerMode;         ///< the sheet for layers is shown: layer_commands.cpp
extern const Mode kPartsMode;         ///< parts are in hand for the tool that moves them: place_commands.cpp

}  // namespace spineloft::app
