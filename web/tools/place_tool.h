// Takes parts in hand in the solid view: a handle of the gizmo, the body of a part, or two fingers.
#pragma once

#include "web/edit/gizmo.h"
#include "web/tools/pinch.h"
#include "web/tools/tool.h"

namespace spineloft::tools {

class PlaceTool final : public Tool {
 public:
  void begin(const ToolEnv& env, const ToolEvent& event) override;
  void move(const ToolEnv& env, const ToolEvent& event) override;
  void commit(const ToolEnv& env) override;
  void cancel(const ToolEnv& env) override;
  bool takesPair() const override { return !parts_.empty(); }
  void followPair(const ToolEnv& env, const FingerPair& from, const FingerPair& to) override;

 private:
  void show(const ToolEnv& env, const document::Motion& motion);
  /// Of a dragged body with the surface under the pointer; the plain motion where there is none.
  document::Motion settled(const ToolEnv& env, const ToolEvent& event, const document::Motion& motion) const;

  DragWatch watch_;
  app::GizmoDrag drag_;
  std::vector<PartId> parts_;
  PartId pressed_;  ///< the part whose body was pressed
  bool moved_ = false;
  bool pairing_ = false;
  double beganMs_ = 0, nowMs_ = 0;
  bool touch_ = false;
  app::ClientPoint by_;  ///< of two fingers, so far
  double angle_ = 0, factor_ = 1;
  document::Motion motion_;
};

}  // namespace spineloft::tools
