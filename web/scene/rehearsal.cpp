#include "web/scene/rehearsal.h"

#include <array>

#include "engine/base/hash.h"

namespace spineloft::app {
namespace {

constexpr double kSide = 16;  // of a frame, CSS pixels

struct Kind {
  bool held = false, still = false;
  float turn = 0;  ///< of the camera
};

/// On the canvas and beside it, each from a new place, where all is drawn, and from the same one, where what stays as
/// it was is taken from a copy.
constexpr std::array kKinds{Kind{.held = true}, Kind{.held = true}, Kind{.turn = 0.1f}, Kind{.turn = 0.1f},
                            Kind{.still = true, .turn = 0.1f}};

mesh::TriMesh tetrahedron() {
  mesh::TriMesh out;
  out.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  out.uv = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  out.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return out;
}

}  // namespace

Rehearsal::Rehearsal() : picture_{2, 2, std::vector<std::uint8_t>(16, 255)}, solid_{tetrahedron()} {}

bool Rehearsal::done() const { return drawn_ == kKinds.size(); }

void Rehearsal::drawNext(gl::Renderer& renderer) {
  const gl::SceneTexture texture{{Hasher().text("rehearsal").value()}, &picture_};
  gl::Scene scene;
  scene.width = 2 * kSide;
  scene.height = kSide;
  scene.pictureView = scene.pictureAt = {0, 0, kSide, kSide};
  scene.solidView = {kSide, 0, kSide, kSide};
  scene.picture = texture;
  scene.floor.radius = 1;
  for (std::size_t i = 0; i < 2; ++i) {
    gl::SceneMesh mesh;
    mesh.key = {Hasher().text("rehearsal").number(i).value()};
    mesh.mesh = &solid_;
    mesh.texture = texture;
    if (i > 0) mesh.toWorld.m[12] = static_cast<float>(drawn_) / 8;  // one stays, one moves
    scene.meshes.push_back(mesh);
  }
  const Kind& kind = kKinds[drawn_++];
  scene.held = kind.held;
  scene.still = kind.still;
  scene.view.m[12] = kind.turn;
  renderer.draw(scene);
  if (renderer.finished()) renderer.show();
}

}  // namespace spineloft::app
