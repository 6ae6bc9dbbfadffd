// Drags a handle of the spine towards the viewer or away from him, in the solid view from the side.
#pragma once

#include "web/tools/pick.h"

namespace spineloft::tools {

class DepthTool final : public Tool {
 public:
  void begin(const ToolEnv& env, const ToolEvent& event) override;
  void move(const ToolEnv& env, const ToolEvent& event) override;
  void commit(const ToolEnv& env) override;
  void cancel(const ToolEnv& env) override;

 private:
  DragWatch watch_;
  int handle_ = -1;
  app::ClientPoint unit_;  ///< one picture pixel of depth on the canvas, CSS pixels
  geometry::AlongCurve depth_;
};

}  // namespace spineloft::tools
