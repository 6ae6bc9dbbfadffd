// A point of a graph in a panel: added by a tap, dragged, taken away by a double tap or dragged
// out.
#pragma once

#include "web/tools/tool.h"

namespace spineloft::tools {

class DragGraph final : public Tool {
 public:
  explicit DragGraph(const app::GraphArea& area) : area_(area) {}
  void begin(const ToolEnv& env, const ToolEvent& event) override;
  void move(const ToolEnv& env, const ToolEvent& event) override;
  void commit(const ToolEnv& env) override;
  void cancel(const ToolEnv& env) override;

 private:
  bool isBlend() const { return area_.kind == app::GraphArea::Kind::Blend; }
  bool isFixed(std::size_t point) const;
  geometry::AlongCurve shownCurve(const ToolEnv& env, const loft::LoftParams& params, const document::Part& part) const;
  geometry::AlongCurve current(const ToolEnv& env) const;
  app::ClientPoint toCanvas(const ToolEnv& env, const geometry::AlongPoint& p) const;
  void show(const ToolEnv& env);

  app::GraphArea area_;
  DragWatch watch_;
  geometry::AlongCurve start_;  ///< with the point that is held
  std::size_t point_ = 0;
  bool fresh_ = false;  ///< the tap made the point
  bool doubled_ = false;
};

}  // namespace spineloft::tools
