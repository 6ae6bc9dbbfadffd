#include "web/gl/floor_shadow.h"

#include <algorithm>

#include "web/gl/shader_sources.h"

namespace spineloft::gl {
namespace {

constexpr int kSide = 256;

GLint uniform(const Program& program, const char* name) { return glGetUniformLocation(program.name(), name); }

}  // namespace

FloorShadow::Map FloorShadow::makeMap() {
  Map map{Texture::make(), Framebuffer::make()};
  glBindTexture(GL_TEXTURE_2D, map.texture.name());
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, kSide, kSide);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glBindFramebuffer(GL_FRAMEBUFFER, map.framebuffer.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, map.texture.name(), 0);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return map;
}

bool FloorShadow::make() {
  height_ = makeProgram(shaders::kShadowVert, shaders::kShadowFrag, {"position"});
  soften_ = makeProgram(shaders::kQuadVert, shaders::kSoftenFrag, {"corner"});
  if (!height_ || !soften_) return false;
  heights_ = makeMap();
  shadow_ = makeMap();
  fromSky_ = {};
  parts_.clear();
  return true;
}

void FloorShadow::update(const Scene& scene, MeshStore& meshes, const VertexArray& quad) {
  if (scene.floorRadius <= 0) return;
  const Mat4 fromSky = fromAbove(scene.floorCentre, scene.floorRadius, scene.floorCentre.y - 1e-3,
                                 scene.floorCentre.y + std::max(1e-3, scene.floorHeadroom));
  const auto cast = [](const SceneMesh& item) { return Cast{item.key, item.toWorld}; };
  if (fromSky == fromSky_ && std::ranges::equal(scene.meshes, parts_, {}, cast)) return;
  fromSky_ = fromSky;
  parts_.clear();
  for (const SceneMesh& item : scene.meshes) parts_.push_back(cast(item));
  glViewport(0, 0, kSide, kSide);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  drawHeights(scene, meshes);
  drawShadow(quad);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void FloorShadow::drawHeights(const Scene& scene, MeshStore& meshes) const {
  glBindFramebuffer(GL_FRAMEBUFFER, heights_.framebuffer.name());
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  glEnable(GL_BLEND);
  glBlendEquation(GL_MAX);  // the lowest surface over each place counts: the shader writes 1 − height
  glUseProgram(height_.name());
  glUniformMatrix4fv(uniform(height_, "toClip"), 1, GL_FALSE, fromSky_.m.data());
  const GLint toWorld = uniform(height_, "toWorld");
  for (const SceneMesh& item : scene.meshes) {
    const GpuMesh& mesh = meshes.get(item);
    glUniformMatrix4fv(toWorld, 1, GL_FALSE, item.toWorld.m.data());
    glBindVertexArray(mesh.array.name());
    glDrawElements(GL_TRIANGLES, mesh.count, GL_UNSIGNED_INT, nullptr);
  }
  glBlendEquation(GL_FUNC_ADD);
  glDisable(GL_BLEND);
}

void FloorShadow::drawShadow(const VertexArray& quad) const {
  glBindFramebuffer(GL_FRAMEBUFFER, shadow_.framebuffer.name());
  glUseProgram(soften_.name());
  glUniform4f(uniform(soften_, "place"), -1, -1, 2, 2);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, heights_.texture.name());
  glUniform1i(uniform(soften_, "heights"), 0);
  glBindVertexArray(quad.name());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glBindVertexArray(0);
}

void FloorShadow::forget() {
  height_.forget();
  soften_.forget();
  for (Map* map : {&heights_, &shadow_}) {
    map->texture.forget();
    map->framebuffer.forget();
  }
}

}  // namespace spineloft::gl
