// A picture beside the canvas, which is put onto a frame or the canvas later: for canvases that a processor draws. A
// view that stands for a while is drawn once, and solids get smooth edges, which the frames of a gesture do without.
#pragma once

#include <cstdint>

#include "engine/image/image.h"
#include "web/gl/handles.h"

namespace spineloft::gl {

class StillTarget {
 public:
  enum class Depths : std::uint8_t { No, Yes };
  /// `samples` of a pixel; none: one, which is not resolved.
  StillTarget(int samples, Depths depths) : count_(samples), depths_(depths) {}
  /// Binds and clears the target; false when there is none of that size.
  bool begin(int width, int height);
  /// Resolves it and binds `next`, 0 for the canvas.
  void end(GLuint next);
  /// What is drawn into between `begin` and `end`.
  GLuint framebuffer() const { return (count_ > 0 ? samples_ : resolved_).name(); }
  /// There is a target; what it shows is what was drawn last.
  explicit operator bool() const { return static_cast<bool>(resolved_); }
  /// Puts it onto the framebuffer `onto`, 0 for the canvas, which has one sample of a pixel and is bound then:
  /// where its left and lower edges come to lie.
  void copy(GLuint onto, int left, int bottom) const;
  /// RGBA, rows from the top.
  image::Image read() const;
  /// The context is lost: forgets every name.
  void forget();

 private:
  bool make(int width, int height);
  int count_;
  Depths depths_;
  Framebuffer samples_, resolved_;
  Renderbuffer colour_, depth_, pixels_;
  int width_ = 0, height_ = 0;
};

}  // namespace spineloft::gl
