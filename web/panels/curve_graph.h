// A curve along the spine as a small graph whose points can be dragged.
#pragma once

#include <imgui.h>

#include <optional>
#include <string_view>

#include "web/panels/panels.h"

namespace spineloft::panels {

struct CurveGraph {
  app::GraphArea::Kind kind = app::GraphArea::Kind::Along;
  double low = 0, high = 1;    ///< values at the foot and the top, in shown units
  double rest = 0;             ///< the value without points
  const char* unit = "{n}";    ///< a number with its unit
  std::string_view name = {};  ///< in the visitor's language
  ImVec2 size = {};
};
/// Draws it and says where it is (SectionUi::graphs); tools::DragGraph does the rest. Its points are also told one by
/// one (point_control.h): the curve that was asked for so, or none.
std::optional<geometry::AlongCurve> curveGraph(const PanelEnv& env, const CurveGraph& graph,
                                               const geometry::AlongCurve& curve);

/// Whether a part with these numbers would go through itself, which it does not now: then that is said.
bool holdsBack(const PanelEnv& env, const document::Part& part, loft::LoftParams params);

}  // namespace spineloft::panels
