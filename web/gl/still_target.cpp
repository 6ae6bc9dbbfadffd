#include "web/gl/still_target.h"

#include <algorithm>
#include <cstddef>

namespace spineloft::gl {
namespace {

constexpr GLsizei kSamples = 4;

void storage(const Renderbuffer& buffer, GLenum format, int width, int height) {
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, kSamples, format, width, height);
}

void attach(GLenum where, const Renderbuffer& buffer) {
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, where, GL_RENDERBUFFER, buffer.name());
}

bool complete() { return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE; }

}  // namespace

bool StillTarget::make(int width, int height) {
  if (width == width_ && height == height_) return static_cast<bool>(samples_);
  width_ = width;
  height_ = height;
  colour_ = Renderbuffer::make();
  depth_ = Renderbuffer::make();
  texture_ = Texture::make();
  samples_ = Framebuffer::make();
  resolved_ = Framebuffer::make();
  storage(colour_, GL_RGBA8, width, height);
  storage(depth_, GL_DEPTH_COMPONENT24, width, height);
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, width, height);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, samples_.name());
  attach(GL_COLOR_ATTACHMENT0, colour_);
  attach(GL_DEPTH_ATTACHMENT, depth_);
  const bool drawable = complete();
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(), 0);
  const bool readable = complete();
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  if (!drawable || !readable) samples_ = Framebuffer();
  return drawable && readable;
}

bool StillTarget::begin(int width, int height) {
  if (!make(width, height)) return false;
  glBindFramebuffer(GL_FRAMEBUFFER, samples_.name());
  glViewport(0, 0, width, height);
  glScissor(0, 0, width, height);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  return true;
}

void StillTarget::end() {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, samples_.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.name());
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
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
  texture_.forget();
  width_ = height_ = 0;
}

}  // namespace spineloft::gl
