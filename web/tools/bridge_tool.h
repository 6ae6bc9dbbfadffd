// Joins places of parts in the solid view: a drag from one to another makes a bridge, its knobs move its ends.
#pragma once

#include <optional>

#include "web/edit/bridging.h"
#include "web/tools/pick.h"

namespace spineloft::tools {

class BridgeTool final : public Tool {
 public:
  void begin(const ToolEnv& env, const ToolEvent& event) override;
  void move(const ToolEnv& env, const ToolEvent& event) override;
  void commit(const ToolEnv& env) override;
  void cancel(const ToolEnv& env) override;

 private:
  DragWatch watch_;
  int rim_ = -1;                          ///< the end that is dragged
  PartId part_;                           ///< its bridge
  PartId pressed_;                        ///< what is chosen by a tap
  std::optional<app::BridgePlace> from_;  ///< where a new one begins
  std::optional<document::BridgeRecipe> made_;
};

}  // namespace spineloft::tools
