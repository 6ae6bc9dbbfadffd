#include "web/gl/floor_shadow.h"

#include <algorithm>

#include "web/gl/shader_sources.h"

namespace spineloft::gl {
namespace {

constexpr int kHeightsSide = 256, kShadowSide = 128;

GLint uniform(const Program& program, const char* name) { return glGetUniformLocation(program.name(), name); }

}  // namespace

FloorShadow::Map FloorShadow::makeMap(int side) {
  Map map{Texture::make(), Framebuffer::make()};
  glBindTexture(GL_TEXTURE_2D, map.texture.name());
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, side, side);
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
  if (!isLinked(height_) || !isLinked(soften_)) return false;
  heights_ = makeMap(kHeightsSide);
  kept_ = makeMap(kHeightsSide);
  shadow_ = makeMap(kShadowSide);
  fromSky_ = {};
  casts_.clear();
  items_.forget();
  return true;
}

void FloorShadow::update(const Scene& scene, MeshStore& meshes, const VertexArray& quad) {
  const auto& [centre, radius, headroom] = scene.floor;
  if (radius <= 0) return;
  const Mat4 fromSky = fromAbove(centre, radius, centre.y - 1e-3, centre.y + std::max(1e-3, headroom));
  const auto cast = [](const SceneMesh& item) { return Cast{item.key, item.toWorld}; };
  const bool sameFloor = fromSky == fromSky_;
  if (sameFloor && scene.hurried) return;
  if (sameFloor && std::ranges::equal(scene.meshes, casts_, {}, cast)) return;
  fromSky_ = fromSky;
  casts_.clear();
  for (const SceneMesh& item : scene.meshes) casts_.push_back(cast(item));
  items_.follow(casts_, sameFloor);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  drawHeights(scene, meshes);
  drawShadow(quad);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void FloorShadow::drawHeights(const Scene& scene, MeshStore& meshes) {
  glViewport(0, 0, kHeightsSide, kHeightsSide);
  glClearColor(0, 0, 0, 0);
  if (items_.share()) {
    glBindFramebuffer(GL_FRAMEBUFFER, kept_.framebuffer.name());
    glClear(GL_COLOR_BUFFER_BIT);
    drawCasts(scene, meshes, items_.picture());
  }
  glBindFramebuffer(GL_FRAMEBUFFER, heights_.framebuffer.name());
  if (items_.picture().empty()) {
    glClear(GL_COLOR_BUFFER_BIT);
  } else {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, kept_.framebuffer.name());
    glBlitFramebuffer(0, 0, kHeightsSide, kHeightsSide, 0, 0, kHeightsSide, kHeightsSide, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
  }
  drawCasts(scene, meshes, items_.others());
}

void FloorShadow::drawCasts(const Scene& scene, MeshStore& meshes, const std::vector<Cast>& casts) const {
  glEnable(GL_BLEND);
  glBlendEquation(GL_MAX);  // the lowest surface over each place counts: the shader writes 1 − height
  glUseProgram(height_.name());
  glUniformMatrix4fv(uniform(height_, "toClip"), 1, GL_FALSE, fromSky_.m.data());
  const GLint toWorld = uniform(height_, "toWorld");
  for (const SceneMesh& item : scene.meshes) {
    if (std::ranges::find(casts, Cast{item.key, item.toWorld}) == casts.end()) continue;
    const GpuMesh& mesh = meshes.get(item);
    glUniformMatrix4fv(toWorld, 1, GL_FALSE, item.toWorld.m.data());
    glBindVertexArray(mesh.array.name());
    glDrawElements(GL_TRIANGLES, mesh.count, GL_UNSIGNED_INT, nullptr);
  }
  glBlendEquation(GL_FUNC_ADD);
  glDisable(GL_BLEND);
}

void FloorShadow::drawShadow(const VertexArray& quad) const {
  glViewport(0, 0, kShadowSide, kShadowSide);
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
  for (Map* map : {&heights_, &kept_, &shadow_}) {
    map->texture.forget();
    map->framebuffer.forget();
  }
}

}  // namespace spineloft::gl
