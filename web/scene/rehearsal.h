// Graphics drivers make what they draw with at the first frame that needs it, and the hand waits: a processor that
// draws takes a tenth of a second and more. Tiny frames of every kind, drawn while nobody waits, have it made before.
#pragma once

#include <cstddef>

#include "web/gl/renderer.h"

namespace spineloft::app {

class Rehearsal {
 public:
  Rehearsal();
  /// All frames have been drawn.
  bool done() const;
  /// Draws the next of them, below the panels that Dear ImGui has just laid out. Not when done.
  void drawNext(gl::Renderer& renderer);

 private:
  image::Image picture_;
  mesh::TriMesh solid_;
  std::size_t drawn_ = 0;
};

}  // namespace spineloft::app
