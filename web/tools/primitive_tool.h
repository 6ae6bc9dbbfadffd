// Shapes on the picture: a drag makes one from one end of its axis to the other, a drag of a handle changes the one in
// hand, a line that begins at its outline or goes round it redraws that; a tap fits one to a thing. The solid follows
// the pen. In a side picture of a loft or a puff in hand a line or a tap is its side outline.
#pragma once

#include <optional>
#include <vector>

#include "web/edit/shaping.h"
#include "web/tools/pick.h"

namespace spineloft::tools {

class PrimitiveTool final : public Tool {
 public:
  void begin(const ToolEnv& env, const ToolEvent& event) override;
  void move(const ToolEnv& env, const ToolEvent& event) override;
  void commit(const ToolEnv& env) override;
  void cancel(const ToolEnv& env) override;

 private:
  void drag(const ToolEnv& env, app::ClientPoint at);
  void draw(const ToolEnv& env);
  void lay(const ToolEnv& env, app::ClientPoint at);
  bool goesRound() const;
  void tap(const ToolEnv& env) const;
  DragWatch watch_;
  std::optional<app::SeenShape> seen_;  ///< in hand when the press came
  PartId aside_;                        ///< else the loft or puff that the picture shows from the side
  std::optional<app::ShapeHandle> handle_;
  int held_ = -1;         ///< of shapeHandles
  bool outline_ = false;  ///< the line is for its outline
  bool begunAtOutline_ = false;
  std::vector<PicturePoint> line_;             ///< from the press on
  std::optional<document::ShapeRecipe> made_;  ///< by a handle, or new: the last one that can be
};

}  // namespace spineloft::tools
