// What a pointer works on a graph itself, for those who use none: told to the page among its controls, never in sight,
// and not drawn.
#pragma once

#include <imgui.h>

#include <optional>
#include <string>
#include <string_view>

#include "web/panels/panels.h"

namespace spineloft::panels {

struct PointControl {
  std::string id;
  std::string_view words;  ///< in the visitor's language
  ImVec2 at;               ///< its middle
};
/// A number of it: what it is to become, where that was asked for.
std::optional<double> pointSlider(const PanelEnv& env, const PointControl& what, const app::Control::Slide& slide);
/// Something that is done with it; true: now.
bool pointButton(const PanelEnv& env, const PointControl& what);

/// The handles that can be dragged in the views: points of an outline, the depth of a spine.
void tellHandles(const PanelEnv& env);

}  // namespace spineloft::panels
