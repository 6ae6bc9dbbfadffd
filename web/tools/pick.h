// What lies under the pointer for the tool in use: the same for hovering, pressing and the cursor.
#pragma once

#include "web/edit/editing.h"
#include "web/tools/tool.h"

namespace spineloft::tools {

/// How near the pointer must come to a point to grab it, CSS pixels.
inline constexpr double kMouseReach = 11, kTouchReach = 24;

/// Under a point of the picture view.
app::Hover pickInPicture(const ToolEnv& env, const ToolEvent& event);
/// Under a point of the solid view.
app::Hover pickInSolid(const ToolEnv& env, const ToolEvent& event);
/// In the solid view beside the part in hand, so near that a line from there is meant for its outline.
bool isBesidePart(const ToolEnv& env, const ToolEvent& event);
/// What a picture pixel nearer to the one who looks at the picture is on the canvas, at a place of a part; CSS pixels.
/// Seen from the front depth has no length on the screen; then it goes down, and not too little.
app::ClientPoint nearerOnCanvas(const ToolEnv& env, const pipeline::ToWorld& toWorld, ModelPoint at);

/// The CSS cursor that says what a press would do there.
const char* cursorFor(const app::UiState& ui, app::Focus view);

/// The selected part when it lies on the picture in view and has a shape.
app::Subject editedPart(const ToolEnv& env);
/// A tap: takes the part in hand, or lets go of all where there is none; `add`: besides what is in hand.
void selectTapped(const ToolEnv& env, PartId part, bool add = false);
PicturePoint toPicture(const ToolEnv& env, app::ClientPoint at);
/// Adds a point unless it is too close to the last one to matter. True when it was added.
bool extend(const ToolEnv& env, std::vector<PicturePoint>& stroke, app::ClientPoint at);

}  // namespace spineloft::tools
