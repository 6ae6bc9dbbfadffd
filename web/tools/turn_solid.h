// Turns or shifts the camera of the solid view. A click selects the part under it.
#pragma once

#include "web/tools/tool.h"

namespace spineloft::tools {

class TurnSolid final : public Tool {
 public:
  enum class Mode { Orbit, Pan };
  explicit TurnSolid(Mode mode) : mode_(mode) {}
  void begin(const ToolEnv& env, const ToolEvent& event) override;
  void move(const ToolEnv& env, const ToolEvent& event) override;
  void commit(const ToolEnv& env) override;
  void cancel(const ToolEnv&) override {}

 private:
  Mode mode_;
  DragWatch watch_;
  bool stops_ = false;  ///< a flight along a part: a click does nothing else
  bool adds_ = false;   ///< a click takes one more part in hand
};

}  // namespace spineloft::tools
