// Scribbles over edges that are not to count, with a round brush. A tap on a scribble removes it.
#pragma once

#include "web/tools/pick.h"

namespace spineloft::tools {

class IgnoreTool final : public Tool {
 public:
  void begin(const ToolEnv& env, const ToolEvent& event) override;
  void move(const ToolEnv& env, const ToolEvent& event) override;
  void commit(const ToolEnv& env) override;
  void cancel(const ToolEnv& env) override;

 private:
  DragWatch watch_;
  app::Hover under_;
};

}  // namespace spineloft::tools
