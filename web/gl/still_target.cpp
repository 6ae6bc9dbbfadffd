#include "web/gl/still_target.h"

#include <algorithm>
#include <cstddef>

namespace spineloft::gl {
namespace {

Renderbuffer makeBuffer(GLsizei samples, GLenum format, int width, int height) {
  Renderbuffer buffer = Renderbuffer::make();
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  return buffer;
}

/// False when the framebuffer is not complete with it.
bool attach(const Framebuffer& framebuffer, GLenum where, const Renderbuffer& buffer) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, where, GL_RENDERBUFFER, buffer.name());
  return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

}  // namespace

bool StillTarget::make(int width, int height) {
  if (width == width_ && height == height_) return static_cast<bool>(resolved_);
  width_ = width;
  height_ = height;
  pixels_ = makeBuffer(0, GL_RGBA8, width, height);
  resolved_ = Framebuffer::make();
  bool complete = attach(resolved_, GL_COLOR_ATTACHMENT0, pixels_);
  if (count_ > 0) {
    colour_ = makeBuffer(count_, GL_RGBA8, width, height);
    samples_ = Framebuffer::make();
    complete = attach(samples_, GL_COLOR_ATTACHMENT0, colour_) && complete;
  }
  if (depths_ == Depths::Yes) {
    depth_ = makeBuffer(count_, GL_DEPTH_COMPONENT24, width, height);
    complete = attach(count_ > 0 ? samples_ : resolved_, GL_DEPTH_ATTACHMENT, depth_) && complete;
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  if (!complete) resolved_ = Framebuffer();
  return complete;
}

bool StillTarget::begin(int width, int height) {
  if (!make(width, height)) return false;
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer());
  glViewport(0, 0, width, height);
  glScissor(0, 0, width, height);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  return true;
}

void StillTarget::end(GLuint next) {
  if (count_ > 0) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, samples_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.name());
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, next);
}

void StillTarget::copy(GLuint onto, int left, int bottom) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, onto);
  glBlitFramebuffer(0, 0, width_, height_, left, bottom, left + width_, bottom + height_, GL_COLOR_BUFFER_BIT,
                    GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, onto);
}

image::Image StillTarget::read() const {
  const std::size_t row = std::size_t{4} * static_cast<std::size_t>(width_);
  image::Image out{width_, height_, {}};
  out.pixels.resize(row * static_cast<std::size_t>(height_));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.name());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, out.pixels.data());
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  const auto rowAt = [&](int y) { return out.pixels.begin() + static_cast<std::ptrdiff_t>(row) * y; };
  for (int top = 0, bottom = height_ - 1; top < bottom; ++top, --bottom) {
    std::swap_ranges(rowAt(top), rowAt(top + 1), rowAt(bottom));  // GL begins at the bottom
  }
  return out;
}

void StillTarget::forget() {
  samples_.forget();
  resolved_.forget();
  colour_.forget();
  depth_.forget();
  pixels_.forget();
  width_ = height_ = 0;
}

}  // namespace spineloft::gl
