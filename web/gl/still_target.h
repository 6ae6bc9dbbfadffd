// A view that stands for a while is drawn once, and later frames take it from there: for canvases that a processor
// draws. Solids get smooth edges with it, which the frames of a gesture do without.
#pragma once

#include "engine/image/image.h"
#include "web/gl/handles.h"

namespace spineloft::gl {

class StillTarget {
 public:
  /// `samples` of a pixel; with none there are no depths either.
  explicit StillTarget(int samples) : count_(samples) {}
  /// Binds and clears the target; false when there is none of that size.
  bool begin(int width, int height);
  /// Resolves it and binds the canvas again.
  void end();
  /// There is a target; what it shows is what was drawn last.
  explicit operator bool() const { return static_cast<bool>(resolved_); }
  /// Puts it onto the canvas, which has one sample of a pixel: where its left and lower edges come to lie.
  void copy(int left, int bottom) const;
  /// RGBA, rows from the top.
  image::Image read() const;
  /// The context is lost: forgets every name.
  void forget();

 private:
  bool make(int width, int height);
  int count_;
  Framebuffer samples_, resolved_;
  Renderbuffer colour_, depth_, pixels_;
  int width_ = 0, height_ = 0;
};

}  // namespace spineloft::gl
