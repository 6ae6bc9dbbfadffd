#include <cstdio>

#include "web/gl/handles.h"

namespace spineloft::gl {
namespace {

GLuint compile(GLenum kind, std::string_view source) {
  const GLuint shader = glCreateShader(kind);
  const char* text = source.data();
  const auto length = static_cast<GLint>(source.size());
  glShaderSource(shader, 1, &text, &length);
  glCompileShader(shader);
  return shader;
}

}  // namespace

Program makeProgram(std::string_view vertexSource, std::string_view fragmentSource,
                    std::initializer_list<const char*> attributes) {
  const GLuint vertex = compile(GL_VERTEX_SHADER, vertexSource);
  const GLuint fragment = compile(GL_FRAGMENT_SHADER, fragmentSource);
  Program program = Program::make();
  glAttachShader(program.name(), vertex);
  glAttachShader(program.name(), fragment);
  GLuint index = 0;
  for (const char* name : attributes) glBindAttribLocation(program.name(), index++, name);
  glLinkProgram(program.name());
  glDeleteShader(vertex);
  glDeleteShader(fragment);
  return program;
}

bool isLinked(const Program& program) {
  GLint good = 0;
  glGetProgramiv(program.name(), GL_LINK_STATUS, &good);
  if (good) return true;
  char log[2048] = {};
  glGetProgramInfoLog(program.name(), sizeof log, nullptr, log);
  std::fprintf(stderr, "program: %s\n", log);
  GLuint shaders[2] = {};
  GLsizei count = 0;
  glGetAttachedShaders(program.name(), 2, &count, shaders);
  for (GLsizei i = 0; i < count; ++i) {
    glGetShaderInfoLog(shaders[i], sizeof log, nullptr, log);
    std::fprintf(stderr, "shader: %s\n", log);
  }
  return false;
}

}  // namespace spineloft::gl
