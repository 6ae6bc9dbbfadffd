// Edits the bones of a puff on the picture: a tap leaves a bone out or takes it back, a drag moves an end, a knob or a
// slice, a line from a bone is a new one. The solid follows the pen.
#pragma once

#include <optional>
#include <vector>

#include "web/edit/puff_bones.h"
#include "web/tools/pick.h"

namespace spineloft::tools {

class BoneTool final : public Tool {
 public:
  /// In the solid view a slice is dragged along the bones.
  explicit BoneTool(app::Focus view = app::Focus::Picture) : view_(view) {}
  void begin(const ToolEnv& env, const ToolEvent& event) override;
  void move(const ToolEnv& env, const ToolEvent& event) override;
  void commit(const ToolEnv& env) override;
  void cancel(const ToolEnv& env) override;

 private:
  std::optional<app::BoneEdit> changed(const ToolEnv& env, const app::BonedPuff& puff, app::ClientPoint at);
  void tap(const ToolEnv& env) const;
  app::Focus view_;
  DragWatch watch_;
  int held_ = -1;  ///< of boneHandles
  std::optional<app::BoneHandle> handle_;
  PartId under_;                       ///< the part where the press was
  std::optional<app::BoneEdit> edit_;  ///< the last one that finds its place
};

}  // namespace spineloft::tools
