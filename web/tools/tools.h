// The tool of a press.
#pragma once

#include <memory>

#include "web/tools/tool.h"

namespace spineloft::tools {

/// What a press in the picture view begins, by the tool that is chosen.
std::unique_ptr<Tool> pictureTool(const ToolEnv& env, app::ToolKind kind);
/// What a press in the solid view begins: a handle of the depth under the pointer, else the camera.
std::unique_ptr<Tool> solidTool(const ToolEnv& env, const ToolEvent& event);

}  // namespace spineloft::tools
