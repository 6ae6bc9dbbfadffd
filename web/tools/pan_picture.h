// Drags the picture about. A click selects.
#pragma once

#include "web/tools/tool.h"

namespace spineloft::tools {

class PanPicture final : public Tool {
 public:
  void begin(const ToolEnv& env, const ToolEvent& event) override;
  void move(const ToolEnv& env, const ToolEvent& event) override;
  void commit(const ToolEnv& env) override;
  void cancel(const ToolEnv&) override {}

 private:
  DragWatch watch_;
  bool adds_ = false;  ///< a click takes one more part in hand
};

/// Size of the shown picture; 0 × 0 without one.
image::Size shownPicture(const ToolEnv& env);

}  // namespace spineloft::tools
