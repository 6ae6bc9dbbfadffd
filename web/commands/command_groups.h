// The groups of rows that make up the command table, one file each.
#pragma once

#include <span>

#include "web/commands/commands.h"

namespace spineloft::app {

std::span<const Command> generalCommands();       ///< board, parts, views: command_table.cpp
std::span<const Command> ribCommands();           ///< editing ribs, ignoring edges: rib_commands.cpp
std::span<const Command> regionCommands();        ///< puffs and flat pieces: region_commands.cpp
std::span<const Command> puffBoneCommands();      ///< bones of puffs: puff_bone_commands.cpp
std::span<const Command> latheCommands();         ///< spun parts: lathe_commands.cpp
std::span<const Command> layerCommands();         ///< parts drawn layer by layer: layer_commands.cpp
std::span<const Command> layerSettingCommands();  ///< of a whole such part: layer_setting_commands.cpp
std::span<const Command> shapeCommands();         ///< shapes, pictures that are sides: shape_commands.cpp
std::span<const Command> shapeToolCommands();     ///< shapes by hand and by keys: shape_tool_commands.cpp
std::span<const Command> lineCommands();          ///< line drawings: line_commands.cpp
std::span<const Command> pullCommands();          ///< lines that move the surface of a part: pull_commands.cpp
std::span<const Command> bridgeCommands();        ///< tubes from part to part: bridge_commands.cpp
std::span<const Command> reliefCommands();        ///< detail on the front of parts: relief_commands.cpp
std::span<const Command> cutCommands();           ///< cutting out of the picture: cut_commands.cpp
std::span<const Command> outlineCommands();       ///< points of outlines by keys: outline_commands.cpp
std::span<const Command> spineCommands();         ///< moving and posing spines: bone_commands.cpp
std::span<const Command> sectionCommands();       ///< sections along the spine, curves: slice_commands.cpp
std::span<const Command> alongCommands();         ///< copied slices, flights: along_commands.cpp
std::span<const Command> sectionBoardCommands();  ///< drawing a section: slice_board_commands.cpp
std::span<const Command> sketchCommands();        ///< paper, pen and eraser: sketch_commands.cpp
std::span<const Command> placeCommands();         ///< places, copies, groups: place_commands.cpp
std::span<const Command> lookCommands();          ///< surfaces, files with them: look_commands.cpp
std::span<const Command> sizeCommands();          ///< how tall, and whether it can be printed: size_commands.cpp
std::span<const Command> solidCommands();         ///< solids made of parts: solid_commands.cpp
std::span<const Command> hollowCommands();        ///< shown before it is made hollow: hollow_commands.cpp
std::span<const Command> keepCommands();          ///< models on this device, project files: keep_commands.cpp

}  // namespace spineloft::app
