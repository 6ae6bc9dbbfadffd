// Drags rib ends; neighbours follow softly. A tap on an end chooses it, a tap on the dot of another
// place moves the end there, a tap elsewhere selects a part.
#pragma once

#include "web/tools/pick.h"

namespace spineloft::tools {

class RibTool final : public Tool {
 public:
  void begin(const ToolEnv& env, const ToolEvent& event) override;
  void move(const ToolEnv& env, const ToolEvent& event) override;
  void commit(const ToolEnv& env) override;
  void cancel(const ToolEnv& env) override;

 private:
  void tap(const ToolEnv& env) const;
  DragWatch watch_;
  app::Hover under_;     ///< where the press was
  PicturePoint to_;      ///< where the end is dragged
  PicturePoint offset_;  ///< from the pointer to the end as it was grabbed
};

}  // namespace spineloft::tools
