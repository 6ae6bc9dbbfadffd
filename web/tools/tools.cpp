#include "web/tools/tools.h"

#include "web/tools/bone_tool.h"
#include "web/tools/bridge_tool.h"
#include "web/tools/depth_tool.h"
#include "web/tools/draw_spine.h"
#include "web/tools/ignore_tool.h"
#include "web/tools/line_tool.h"
#include "web/tools/pan_picture.h"
#include "web/tools/pin_tool.h"
#include "web/tools/place_tool.h"
#include "web/tools/primitive_tool.h"
#include "web/tools/pull_tool.h"
#include "web/tools/region_tool.h"
#include "web/tools/rib_tool.h"
#include "web/tools/shape_tool.h"
#include "web/tools/sheet_tool.h"
#include "web/tools/sketch_pen.h"
#include "web/tools/spine_tool.h"
#include "web/tools/turn_solid.h"

namespace spineloft::tools {

std::unique_ptr<Tool> pictureTool(const ToolEnv& env, app::ToolKind kind) {
  using app::ToolKind;
  switch (kind) {
    case ToolKind::Draw:
      return std::make_unique<DrawSpine>();
    case ToolKind::Ribs:
      return std::make_unique<RibTool>();
    case ToolKind::Shape:
      return std::make_unique<ShapeTool>();
    case ToolKind::Spine:
      if (app::bonesInHand(env.document, env.derived, env.ui)) return std::make_unique<BoneTool>();
      return std::make_unique<SpineTool>();
    case ToolKind::Ignore:
      return std::make_unique<IgnoreTool>();
    case ToolKind::Inflate:
    case ToolKind::Extrude:
    case ToolKind::Spin:
      return std::make_unique<RegionTool>();
    case ToolKind::Primitive:
      return std::make_unique<PrimitiveTool>();
    case ToolKind::Lines:
      return std::make_unique<LineTool>();
    case ToolKind::Pen:
    case ToolKind::Eraser:
      return std::make_unique<SketchPen>(kind == ToolKind::Eraser);
    case ToolKind::Hand:
    case ToolKind::Place:  // which work in the solid view
    case ToolKind::Layers:
    case ToolKind::Pull:
    case ToolKind::Bridge:
    case ToolKind::kCount:
      break;
  }
  return std::make_unique<PanPicture>();
}

std::unique_ptr<Tool> solidTool(const ToolEnv& env, const ToolEvent& event) {
  if (env.ui.fliesAlong()) return std::make_unique<TurnSolid>(TurnSolid::Mode::Orbit);  // which stops
  const app::Hover under = pickInSolid(env, event);
  if (under.depth >= 0 && env.ui.tool == app::ToolKind::Lines) return std::make_unique<PinTool>();
  if (under.depth >= 0) return std::make_unique<DepthTool>();
  if (env.ui.solids.pointing || env.ui.solids.hollow) return std::make_unique<TurnSolid>(TurnSolid::Mode::Orbit);
  if (under.bone >= 0) return std::make_unique<BoneTool>(app::Focus::Solid);
  const bool pulls = env.ui.tool == app::ToolKind::Pull;
  if (pulls && (under.pull >= 0 || under.part || isBesidePart(env, event))) return std::make_unique<PullTool>();
  if (env.ui.tool == app::ToolKind::Bridge && (under.rim >= 0 || under.part)) return std::make_unique<BridgeTool>();
  if (under.sheet != SheetHold::Nothing) return std::make_unique<SheetTool>();
  const bool held = under.gizmo != app::GizmoHandle::None || under.part;
  if (env.ui.tool == app::ToolKind::Place && held) return std::make_unique<PlaceTool>();
  return std::make_unique<TurnSolid>(TurnSolid::Mode::Orbit);
}

}  // namespace spineloft::tools
