// Which presses are about sections: on the board, on a graph in a panel, on a section's handle.
#pragma once

#include <memory>

#include "web/tools/tool.h"

namespace spineloft::tools {

/// Whether a press here is for the board or for a graph, whatever lies below.
bool isForSections(const app::UiState& ui, app::ClientPoint at);

/// The tool of such a press. Also in the picture view: the tool of a press on a section's handle, or
/// anywhere while a section waits for its place. Null: the press is about something else.
std::unique_ptr<Tool> sectionTool(const ToolEnv& env, const ToolEvent& event);

/// The place along the spine that a graph shows at this point; none elsewhere.
std::optional<double> placeInGraph(const app::UiState& ui, app::ClientPoint at);

/// The CSS cursor of such a place; null elsewhere.
const char* sectionCursor(const ToolEnv& env, app::ClientPoint at);

/// The section whose handle is within reach of `at` in the picture view; none when handles are hidden
/// or farther.
std::optional<std::size_t> sectionHandleAt(const ToolEnv& env, app::ClientPoint at, double reach);

/// Whether this tap and the one before it are one double tap. Remembers it.
bool isDoubleTap(app::SectionUi& sections, const ToolEvent& event);

/// CSS pixels within which a point is taken hold of.
inline double reachOf(const ToolEvent& event) { return event.touch() ? 24 : 12; }

}  // namespace spineloft::tools
