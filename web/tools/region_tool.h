// Puffs and flat pieces: a line round a thing becomes a part, a tap cuts the thing out; points of an
// outline that is selected are dragged.
#pragma once

#include "web/tools/pick.h"

namespace spineloft::tools {

class RegionTool final : public Tool {
 public:
  void begin(const ToolEnv& env, const ToolEvent& event) override;
  void move(const ToolEnv& env, const ToolEvent& event) override;
  void commit(const ToolEnv& env) override;
  void cancel(const ToolEnv& env) override;

 private:
  void tap(const ToolEnv& env) const;
  void drag(const ToolEnv& env, const ToolEvent& event);
  void draw(const ToolEnv& env, const ToolEvent& event);
  DragWatch watch_;
  std::optional<app::OutlinePoint> grabbed_;
  PartId part_;  ///< whose point it is
  PicturePoint to_{};
};

}  // namespace spineloft::tools
