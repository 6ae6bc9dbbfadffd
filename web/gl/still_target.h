// Smooth edges where the canvas has none: a frame that will stand for a while is drawn once into a
// multisampled target. Moving frames do without, because a processor draws them.
#pragma once

#include "engine/image/image.h"
#include "web/gl/handles.h"

namespace spineloft::gl {

class StillTarget {
 public:
  /// Binds and clears the target; false when there is none of that size.
  bool begin(int width, int height);
  /// Resolves it, binds the canvas again and returns the texture with the result.
  GLuint end();
  /// What `end` resolved: RGBA, rows from the top.
  image::Image read() const;
  /// The context is lost: forgets every name.
  void forget();

 private:
  bool make(int width, int height);
  Framebuffer samples_, resolved_;
  Renderbuffer colour_, depth_;
  Texture texture_;
  int width_ = 0, height_ = 0;
};

}  // namespace spineloft::gl
