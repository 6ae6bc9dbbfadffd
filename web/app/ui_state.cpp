#include "web/app/ui_state.h"

#include <array>

namespace spineloft::app {

std::string_view toolKey(ToolKind tool) {
  static constexpr std::array<std::string_view, static_cast<std::size_t>(ToolKind::kCount)> kKeys =
      {"draw",  "hand",  "ribs", "shape",  "bone", "ignore",
       "puff", "sheet", "pen",  "eraser", "move"};
  return tool < ToolKind::kCount ? kKeys[static_cast<std::size_t>(tool)] : std::string_view();
}

}  // namespace spineloft::app
