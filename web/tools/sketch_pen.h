// Pen and eraser on paper: the ink is seen at once, and becomes one stroke of the sketch.
#pragma once

#include "web/tools/tool.h"

namespace spineloft::tools {

class SketchPen final : public Tool {
 public:
  explicit SketchPen(bool erase) : erase_(erase) {}
  void begin(const ToolEnv& env, const ToolEvent& event) override;
  void move(const ToolEnv& env, const ToolEvent& event) override;
  void commit(const ToolEnv& env) override;
  void cancel(const ToolEnv& env) override;

 private:
  void add(const ToolEnv& env, const ToolEvent& event);
  bool erase_;
};

}  // namespace spineloft::tools
