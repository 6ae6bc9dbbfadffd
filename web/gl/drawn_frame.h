// What the canvas shows, so that a frame like it is not drawn again: a processor may be what draws.
#pragma once

#include <cstddef>
#include <vector>

#include "web/gl/renderer.h"

struct ImDrawData;

namespace spineloft::gl {

class DrawnFrame {
 public:
  /// True when the canvas shows this scene and these panels already, as smoothly as the scene asks for. Panels are
  /// those that Dear ImGui made, before its textures are named; null: none.
  bool shows(const Scene& scene, const ImDrawData* panels);
  /// The canvas shows something else now.
  void forget() { known_ = false; }

 private:
  bool takePanels(const ImDrawData* panels);

  bool known_ = false;
  Scene scene_;  ///< what it points to may be gone
  std::vector<std::byte> panels_, staging_;
};

}  // namespace spineloft::gl
