// Parts made of regions: a line round a thing, or beside an axis, becomes a part; a tap, a box or a scribble cuts the
// thing out; points of an outline are dragged once the part was tapped, the ends of an axis at any time. While a thing
// is being cut out, strokes correct it.
#pragma once

#include "web/edit/spinning.h"
#include "web/tools/pick.h"

namespace spineloft::tools {

class RegionTool final : public Tool {
 public:
  void begin(const ToolEnv& env, const ToolEvent& event) override;
  void move(const ToolEnv& env, const ToolEvent& event) override;
  void commit(const ToolEnv& env) override;
  void cancel(const ToolEnv& env) override;

 private:
  enum class Way { Outline, Point, Axis, Box, Scribble, Mark };
  static Way wayOf(const app::UiState& ui);
  void tap(const ToolEnv& env) const;
  void drawn(const ToolEnv& env, const std::vector<PicturePoint>& line) const;
  void drag(const ToolEnv& env, const ToolEvent& event);
  void swing(const ToolEnv& env, const ToolEvent& event);
  void draw(const ToolEnv& env, const ToolEvent& event);
  void mark(const ToolEnv& env, const ToolEvent& event) const;
  void scribble(const ToolEnv& env, const ToolEvent& event) const;
  void span(const ToolEnv& env, const ToolEvent& event) const;
  DragWatch watch_;
  std::optional<app::OutlinePoint> grabbed_;
  int end_ = -1;  ///< of the axis
  std::optional<app::ShownAxis> axis_;
  Way way_ = Way::Outline;
  PartId part_;  ///< whose point it is
  PicturePoint to_{};
};

}  // namespace spineloft::tools
