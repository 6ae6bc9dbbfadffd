#include <array>
#include <cstddef>
#include <cstdio>

#include "web/gl/handles.h"

namespace spineloft::gl {
namespace {

GLuint compile(GLenum kind, std::string_view source, std::string_view define) {
  const GLuint shader = glCreateShader(kind);
  const std::size_t version = source.find('\n') + 1;
  const std::array pieces{source.substr(0, version), define, source.substr(version)};
  std::array<const char*, 3> texts{};
  std::array<GLint, 3> lengths{};
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    texts[i] = pieces[i].empty() ? "" : pieces[i].data();
    lengths[i] = static_cast<GLint>(pieces[i].size());
  }
  glShaderSource(shader, 3, texts.data(), lengths.data());
  glCompileShader(shader);
  return shader;
}

}  // namespace

Program makeProgram(std::string_view vertexSource, std::string_view fragmentSource,
                    std::initializer_list<const char*> attributes, std::string_view define) {
  const GLuint vertex = compile(GL_VERTEX_SHADER, vertexSource, define);
  const GLuint fragment = compile(GL_FRAGMENT_SHADER, fragmentSource, define);
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
