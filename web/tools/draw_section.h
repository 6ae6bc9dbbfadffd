// One gesture on the board: a freehand line, a straight line, a box, an ellipse, or a dragged
// point.
#pragma once

#include "engine/sections/drawing.h"
#include "web/tools/tool.h"

namespace spineloft::tools {

class DrawSection final : public Tool {
 public:
  void begin(const ToolEnv& env, const ToolEvent& event) override;
  void move(const ToolEnv& env, const ToolEvent& event) override;
  void commit(const ToolEnv& env) override;
  void cancel(const ToolEnv& env) override;

 private:
  void takePoint(const ToolEnv& env);
  void commitPoint(const ToolEnv& env);
  void commitLine(const ToolEnv& env);

  DragWatch watch_;
  ToolEvent last_;
  SectionPoint from_, to_;
  bool doubled_ = false;
  std::optional<sections::PointRef> held_;   ///< the point under the pointer
  std::optional<sections::PointRef> after_;  ///< the pointer is on the curve after this point
};

}  // namespace spineloft::tools
