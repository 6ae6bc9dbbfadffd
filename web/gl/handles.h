// Move-only owners of GL objects. `forget` lets go of a name whose context is lost.
#pragma once

#include <GLES3/gl3.h>

#include <initializer_list>
#include <string_view>
#include <utility>

namespace spineloft::gl {

template <class Traits>
class Handle {
 public:
  Handle() = default;
  Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~Handle() {
    if (name_ != 0) Traits::destroy(name_);
  }
  static Handle make() {
    Handle handle;
    handle.name_ = Traits::create();
    return handle;
  }
  GLuint name() const { return name_; }
  explicit operator bool() const { return name_ != 0; }
  void forget() { name_ = 0; }

 private:
  GLuint name_ = 0;
};

struct BufferTraits {
  static GLuint create() {
    GLuint name = 0;
    glGenBuffers(1, &name);
    return name;
  }
  static void destroy(GLuint name) { glDeleteBuffers(1, &name); }
};
struct VertexArrayTraits {
  static GLuint create() {
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    return name;
  }
  static void destroy(GLuint name) { glDeleteVertexArrays(1, &name); }
};
struct TextureTraits {
  static GLuint create() {
    GLuint name = 0;
    glGenTextures(1, &name);
    return name;
  }
  static void destroy(GLuint name) { glDeleteTextures(1, &name); }
};
struct RenderbufferTraits {
  static GLuint create() {
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    return name;
  }
  static void destroy(GLuint name) { glDeleteRenderbuffers(1, &name); }
};
struct FramebufferTraits {
  static GLuint create() {
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    return name;
  }
  static void destroy(GLuint name) { glDeleteFramebuffers(1, &name); }
};
struct ProgramTraits {
  static GLuint create() { return glCreateProgram(); }
  static void destroy(GLuint name) { glDeleteProgram(name); }
};

using Buffer = Handle<BufferTraits>;
using VertexArray = Handle<VertexArrayTraits>;
using Texture = Handle<TextureTraits>;
using Renderbuffer = Handle<RenderbufferTraits>;
using Framebuffer = Handle<FramebufferTraits>;
using Program = Handle<ProgramTraits>;

/// Begins to compile and link. `attributes` gives the names of vertex attributes 0, 1, 2 … in order, `define` is a line
/// put below the first one of both sources.
Program makeProgram(std::string_view vertexSource, std::string_view fragmentSource,
                    std::initializer_list<const char*> attributes, std::string_view define = {});
/// Waits for that; the logs are on stderr when it failed. Ask when all programs have been begun: they link side by
/// side.
bool isLinked(const Program& program);

}  // namespace spineloft::gl
