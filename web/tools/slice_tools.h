// Which presses are about slices: on the board, on a graph in a panel, on a slice's handle.
#pragma once

#include <memory>

#include "web/tools/tool.h"

namespace spineloft::tools {

/// Whether a press here is for the board or for a graph, whatever lies below.
bool isForSlices(const app::UiState& ui, app::ClientPoint at);

/// The tool of such a press. Also in the picture view: the tool of a press on a slice's handle, or
/// anywhere while a slice waits for its place. Null: the press is about something else.
std::unique_ptr<Tool> sliceTool(const ToolEnv& env, const ToolEvent& event);

/// The place along the bone that a graph shows at this point; none elsewhere.
std::optional<double> placeInGraph(const app::UiState& ui, app::ClientPoint at);

/// The CSS cursor of such a place; null elsewhere.
const char* sliceCursor(const ToolEnv& env, app::ClientPoint at);

/// The slice whose handle is within reach of `at` in the picture view; none when handles are hidden
/// or farther.
std::optional<std::size_t> sliceHandleAt(const ToolEnv& env, app::ClientPoint at, double reach);

/// Whether this tap and the one before it are one double tap. Remembers it.
bool isDoubleTap(app::SliceUi& slices, const ToolEvent& event);

/// CSS pixels within which a point is taken hold of.
inline double reachOf(const ToolEvent& event) { return event.touch() ? 24 : 12; }

}  // namespace spineloft::tools
