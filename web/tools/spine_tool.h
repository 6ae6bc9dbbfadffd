// Changes the spine of the selected part: a dragged point bends it, a dragged end makes it longer or
// shorter, dragging the line moves it all, and a stroke drawn elsewhere takes its place.
#pragma once

#include "web/tools/pick.h"

namespace spineloft::tools {

class SpineTool final : public Tool {
 public:
  void begin(const ToolEnv& env, const ToolEvent& event) override;
  void move(const ToolEnv& env, const ToolEvent& event) override;
  void commit(const ToolEnv& env) override;
  void cancel(const ToolEnv& env) override;

 private:
  /// The line with the changes of the gesture so far.
  std::vector<PicturePoint> line(const ToolEnv& env, const app::Subject& subject, const ToolEvent& event);
  void tap(const ToolEnv& env) const;
  DragWatch watch_;
  app::Hover under_;
  PicturePoint from_, to_;  ///< of the pointer, in the picture
};

}  // namespace spineloft::tools
