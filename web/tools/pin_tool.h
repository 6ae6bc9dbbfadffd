// Drags a dot of a piece of a line drawing nearer or farther, in the solid view. A tap frees a pin.
#pragma once

#include <optional>

#include "engine/document/action.h"
#include "web/edit/depth_dots.h"
#include "web/tools/pick.h"

namespace spineloft::tools {

class PinTool final : public Tool {
 public:
  void begin(const ToolEnv& env, const ToolEvent& event) override;
  void move(const ToolEnv& env, const ToolEvent& event) override;
  void commit(const ToolEnv& env) override;
  void cancel(const ToolEnv& env) override;

 private:
  DragWatch watch_;
  std::optional<app::DepthDot> dot_;
  app::ClientPoint unit_;  ///< one picture pixel of depth on the canvas, CSS pixels
};

}  // namespace spineloft::tools
