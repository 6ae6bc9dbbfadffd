// Pulls the surface of a part in the solid view: a line on it makes a pull and a ring a bump, a line from its outline
// to its outline moves that, and the knob of a pull is dragged out or in.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "web/edit/pulling.h"
#include "web/tools/pick.h"

namespace spineloft::tools {

class PullTool final : public Tool {
 public:
  void begin(const ToolEnv& env, const ToolEvent& event) override;
  void move(const ToolEnv& env, const ToolEvent& event) override;
  void commit(const ToolEnv& env) override;
  void cancel(const ToolEnv& env) override;

 private:
  void addPlace(const ToolEnv& env, app::ClientPoint at);

  DragWatch watch_;
  int knob_ = -1;
  PartId part_;                                    ///< whose knob it is
  app::ClientPoint unit_;                          ///< of one picture pixel of height on the canvas, CSS pixels
  pull::Pull held_;                                ///< the one whose knob is dragged, as it was
  pipeline::PulledLine line_;                      ///< as it lay
  PartId other_;                                   ///< a part that was pressed and was not in hand
  std::pair<PartId, std::vector<PartId>> before_;  ///< what was in hand then
  bool outline_ = false;                           ///< the line is for the outline
  double farthest_ = 0;                            ///< from its beginning, CSS pixels
  double leastRing_ = 0;                           ///< a ring goes farther than that
  std::size_t copy_ = 0;                           ///< of the part, which the line is on
  double reach_ = 0;                               ///< of its ends, CSS pixels
};

}  // namespace spineloft::tools
