// The main tool: one loose line on the picture becomes a part. A click selects, with shift one more.
#pragma once

#include "web/tools/pick.h"

namespace spineloft::tools {

class DrawSpine final : public Tool {
 public:
  void begin(const ToolEnv& env, const ToolEvent& event) override;
  void move(const ToolEnv& env, const ToolEvent& event) override;
  void commit(const ToolEnv& env) override;
  void cancel(const ToolEnv& env) override;

 private:
  void start(const ToolEnv& env, const ToolEvent& event);
  static bool usesPressure(const ToolEnv& env, const ToolEvent& event);
  DragWatch watch_;
  bool adds_ = false;  ///< shift is down: a click takes one more
};

}  // namespace spineloft::tools
