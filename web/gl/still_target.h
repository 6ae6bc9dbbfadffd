// Smooth edges where the canvas has none: a view that will stand for a while is drawn once into a multisampled target,
// from which later frames take it. Moving frames do without, because a processor draws them.
#pragma once

#include "engine/image/image.h"
#include "web/gl/handles.h"

namespace spineloft::gl {

class StillTarget {
 public:
  /// Binds and clears the target; false when there is none of that size.
  bool begin(int width, int height);
  /// Resolves it and binds the canvas again.
  void end();
  /// There is a target; what it shows is what was drawn last.
  explicit operator bool() const { return static_cast<bool>(samples_); }
  /// What `end` resolved.
  GLuint texture() const { return texture_.name(); }
  /// The same: RGBA, rows from the top.
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
