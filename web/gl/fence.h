// Whether what was asked of the GPU has been done, without waiting for it.
#pragma once

#include <GLES3/gl3.h>

namespace spineloft::gl {

class Fence {
 public:
  Fence() = default;
  Fence(const Fence&) = delete;
  Fence& operator=(const Fence&) = delete;
  ~Fence() { remove(); }
  /// Behind all that was asked for so far, which begins now.
  void set() {
    remove();
    sync_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    glFlush();
  }
  /// Nothing before it is left to do; so too where it was never set. A browser's answer changes between tasks only.
  bool passed() {
    if (sync_ == nullptr) return true;
    GLint status = GL_SIGNALED;
    GLsizei count = 0;
    glGetSynciv(sync_, GL_SYNC_STATUS, 1, &count, &status);
    if (status != GL_SIGNALED) return false;
    remove();
    return true;
  }
  /// The context is lost.
  void forget() { sync_ = nullptr; }

  /// As if it had never been set.
  void remove() {
    if (sync_ != nullptr) glDeleteSync(sync_);
    sync_ = nullptr;
  }

 private:
  GLsync sync_ = nullptr;
};

}  // namespace spineloft::gl
