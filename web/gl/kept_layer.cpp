#include "web/gl/kept_layer.h"

#include "web/gl/shader_sources.h"

namespace spineloft::gl {
namespace {

/// From the same place, in views of the same size, whatever the number of their pixels.
bool sameView(const Scene& a, const Scene& b) {
  return a.solidView == b.solidView && a.height == b.height && a.view == b.view && a.projection == b.projection &&
         a.ground == b.ground;
}

Texture makeTexture(GLenum format, int width, int height) {
  Texture texture = Texture::make();
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glTexStorage2D(GL_TEXTURE_2D, 1, format, width, height);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return texture;
}

}  // namespace

bool KeptLayer::make() {
  program_ = makeProgram(shaders::kQuadVert, shaders::kLayerFrag, {"corner"});
  before_ = {};
  items_.forget();
  width_ = height_ = 0;
  return isLinked(program_);
}

void KeptLayer::follow(const Scene& scene) {
  items_.follow(scene.meshes, sameView(scene, before_));
  if (scene.dpr != before_.dpr) items_.dropPicture();
  before_ = scene;
}

void KeptLayer::begin(int width, int height) {
  if (!framebuffer_) framebuffer_ = Framebuffer::make();
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  if (width != width_ || height != height_) {
    width_ = width;
    height_ = height;
    colours_ = makeTexture(GL_RGBA8, width, height);
    depths_ = makeTexture(GL_DEPTH_COMPONENT24, width, height);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colours_.name(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depths_.name(), 0);
  }
  glViewport(0, 0, width, height);
  glDisable(GL_SCISSOR_TEST);
  glDepthMask(GL_TRUE);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void KeptLayer::end() { glBindFramebuffer(GL_FRAMEBUFFER, 0); }

void KeptLayer::draw(int left, int bottom, const VertexArray& quad) const {
  const auto uniform = [&](const char* name) { return glGetUniformLocation(program_.name(), name); };
  glEnable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glUseProgram(program_.name());
  glUniform4f(uniform("place"), -1, -1, 2, 2);
  glUniform2i(uniform("origin"), left, bottom);
  glUniform1i(uniform("colours"), 0);
  glUniform1i(uniform("depths"), 1);
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, depths_.name());
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, colours_.name());
  glDepthFunc(GL_ALWAYS);
  glBindVertexArray(quad.name());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glBindVertexArray(0);
  glDepthFunc(GL_LEQUAL);
}

void KeptLayer::forget() {
  program_.forget();
  colours_.forget();
  depths_.forget();
  framebuffer_.forget();
  width_ = height_ = 0;
}

}  // namespace spineloft::gl
