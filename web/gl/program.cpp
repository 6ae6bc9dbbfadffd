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
  GLint good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good) return shader;
  char log[2048] = {};
  glGetShaderInfoLog(shader, sizeof log, nullptr, log);
  std::fprintf(stderr, "shader: %s\n", log);
  glDeleteShader(shader);
  return 0;
}

}  // namespace

Program makeProgram(std::string_view vertexSource, std::string_view fragmentSource,
                    std::initializer_list<const char*> attributes) {
  const GLuint vertex = compile(GL_VERTEX_SHADER, vertexSource);
  const GLuint fragment = compile(GL_FRAGMENT_SHADER, fragmentSource);
  Program program;
  if (vertex != 0 && fragment != 0) {
    program = Program::make();
    glAttachShader(program.name(), vertex);
    glAttachShader(program.name(), fragment);
    GLuint index = 0;
    for (const char* name : attributes) glBindAttribLocation(program.name(), index++, name);
    glLinkProgram(program.name());
    GLint good = 0;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &good);
    if (!good) {
      char log[2048] = {};
      glGetProgramInfoLog(program.name(), sizeof log, nullptr, log);
      std::fprintf(stderr, "program: %s\n", log);
      program = Program();
    }
  }
  if (vertex != 0) glDeleteShader(vertex);
  if (fragment != 0) glDeleteShader(fragment);
  return program;
}

}  // namespace spineloft::gl
