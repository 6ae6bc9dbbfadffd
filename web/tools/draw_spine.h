// The main tool: one loose line on the picture becomes a part. A click selects.
#pragma once

#include "web/tools/tool.h"

namespace spineloft::tools {

class DrawSpine final : public Tool {
 public:
  void begin(const ToolEnv& env, app::ClientPoint at) override;
  void move(const ToolEnv& env, app::ClientPoint at) override;
  void commit(const ToolEnv& env) override;
  void cancel(const ToolEnv& env) override;

 private:
  DragWatch watch_;
};

}  // namespace spineloft::tools
