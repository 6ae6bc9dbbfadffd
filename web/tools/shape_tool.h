// A line near the outline of the selected part: the rib ends that it crosses grow or shrink to it.
#pragma once

#include "web/tools/pick.h"

namespace spineloft::tools {

class ShapeTool final : public Tool {
 public:
  void begin(const ToolEnv& env, const ToolEvent& event) override;
  void move(const ToolEnv& env, const ToolEvent& event) override;
  void commit(const ToolEnv& env) override;
  void cancel(const ToolEnv& env) override;

 private:
  DragWatch watch_;
};

}  // namespace spineloft::tools
