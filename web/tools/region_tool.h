// Puffs and flat pieces: a line round a thing becomes a part, a tap, a box or a scribble cuts the thing out; points
// of an outline are dragged once the part was tapped. While a thing is being cut out, strokes correct it.
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
  enum class Way { Outline, Point, Box, Scribble, Mark };
  static Way wayOf(app::CutBy by);
  void tap(const ToolEnv& env) const;
  void drawn(const ToolEnv& env, const std::vector<PicturePoint>& line) const;
  void drag(const ToolEnv& env, const ToolEvent& event);
  void draw(const ToolEnv& env, const ToolEvent& event);
  void mark(const ToolEnv& env, const ToolEvent& event) const;
  void scribble(const ToolEnv& env, const ToolEvent& event) const;
  void span(const ToolEnv& env, const ToolEvent& event) const;
  DragWatch watch_;
  std::optional<app::OutlinePoint> grabbed_;
  Way way_ = Way::Outline;
  PartId part_;  ///< whose point it is
  PicturePoint to_{};
};

}  // namespace spineloft::tools
