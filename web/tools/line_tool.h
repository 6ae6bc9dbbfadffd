// Lines of a line drawing: a drag is a line, seen or hidden; a tap on a crossing swaps two pieces there, one on a ring
// closes its line.
#pragma once

#include "web/tools/pick.h"

namespace spineloft::tools {

class LineTool final : public Tool {
 public:
  void begin(const ToolEnv& env, const ToolEvent& event) override;
  void move(const ToolEnv& env, const ToolEvent& event) override;
  void commit(const ToolEnv& env) override;
  void cancel(const ToolEnv& env) override;

 private:
  void tap(const ToolEnv& env) const;
  DragWatch watch_;
  app::Hover under_;
  std::vector<PicturePoint> line_;  ///< from the press on
  bool hidden_ = false;
  double reach_ = 0;  ///< picture pixels round an end that count as there
};

}  // namespace spineloft::tools
