// On the sheet of the tool Layers, in the solid view: a line draws a layer, the knob at its edge takes it along the
// rail.
#pragma once

#include "web/edit/layer_joints.h"
#include "web/edit/layers.h"
#include "web/tools/pick.h"

namespace spineloft::tools {

using app::SheetHold;
/// What a press there is for, and of which link or fork.
struct SheetGrip {
  SheetHold hold = SheetHold::Nothing;
  int joint = -1;
};
SheetGrip gripAt(const ToolEnv& env, const ToolEvent& event);
/// The wheel above the sheet takes it along its rail; false elsewhere. `by` in CSS pixels of the wheel, down is
/// positive.
bool wheelSheet(const ToolEnv& env, app::ClientPoint at, double by);

class SheetTool final : public Tool {
 public:
  void begin(const ToolEnv& env, const ToolEvent& event) override;
  void move(const ToolEnv& env, const ToolEvent& event) override;
  void commit(const ToolEnv& env) override;
  void cancel(const ToolEnv& env) override;

 private:
  void lift(const ToolEnv& env, const ToolEvent& event);
  void draw(const ToolEnv& env, const ToolEvent& event);
  void raise(const ToolEnv& env, const ToolEvent& event);
  void lean(const ToolEnv& env, const ToolEvent& event);
  /// The part as it would be.
  void show(const ToolEnv& env, const document::StackRecipe& recipe) const;
  void drawRail(const ToolEnv& env, const ToolEvent& event);
  const app::LayerFork& fork() const { return joints_.forks[static_cast<std::size_t>(grip_.joint)]; }

  DragWatch watch_;
  SheetGrip grip_;
  app::Sheet sheet_;                              ///< as the press found it
  app::LayerJoints joints_;                       ///< the same
  pipeline::ToWorld toWorld_;                     ///< the same
  app::ClientPoint last_;                         ///< of the line
  app::ClientPoint unit_;                         ///< a whole rail on the canvas, or the way of a fork, CSS pixels
  double before_ = 0;                             ///< where the sheet was
  std::optional<document::StackRecipe> shifted_;  ///< with the free layer where the hand has it
  double raised_ = 0;                             ///< where the fork is
  geometry::Turn turn_;                           ///< of the leaning sheet
  std::optional<Result<stack::Rail>> rail_;       ///< along the line so far
};

}  // namespace spineloft::tools
