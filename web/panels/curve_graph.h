// A curve along the spine as a small graph whose points can be dragged.
#pragma once

#include <imgui.h>

#include "web/panels/panels.h"

namespace spineloft::panels {

struct CurveGraph {
  app::GraphArea::Kind kind = app::GraphArea::Kind::Along;
  double low = 0, high = 1;  ///< values at the foot and the top, in shown units
  double rest = 0;           ///< the value without points
  const char* unit = "";     ///< behind a number
  ImVec2 size;
};
/// Draws it and says where it is (SectionUi::graphs); tools::DragGraph does the rest.
void curveGraph(const PanelEnv& env, const CurveGraph& graph, const geometry::AlongCurve& curve);

}  // namespace spineloft::panels
