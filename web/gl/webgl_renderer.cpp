#include "web/gl/webgl_renderer.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "engine/image/srgb.h"
#include "web/gl/drawn_frame.h"
#include "web/gl/fence.h"
#include "web/gl/floor_shadow.h"
#include "web/gl/handles.h"
#include "web/gl/kept_layer.h"
#include "web/gl/mesh_store.h"
#include "web/gl/shader_sources.h"
#include "web/gl/still_target.h"
#include "web/gl/texture_store.h"
#include "web/gl/unseen.h"

namespace spineloft::gl {
namespace {

constexpr int kSamples = 4;  ///< of a pixel whose edges are smooth

struct Programs {
  Program background, picture, mesh, floor;
  Program cut;  ///< `mesh` for meshes with a plane; made when there is one
  bool complete() const { return isLinked(background) && isLinked(picture) && isLinked(mesh) && isLinked(floor); }
  void forget() {
    for (Program* p : {&background, &picture, &mesh, &floor, &cut}) p->forget();
  }
};

Program makeMeshProgram(std::string_view define) {
  return makeProgram(shaders::kMeshVert, shaders::kMeshFrag, {"position", "normal", "uv"}, define);
}

bool fades(const SceneMesh& item) { return item.fadeBefore.has_value(); }

Programs makePrograms() {
  Programs out;
  out.background = makeProgram(shaders::kQuadVert, shaders::kBackgroundFrag, {"corner"});
  out.picture = makeProgram(shaders::kQuadVert, shaders::kPictureFrag, {"corner"});
  out.mesh = makeMeshProgram({});
  out.floor = makeProgram(shaders::kFloorVert, shaders::kFloorFrag, {"corner"});
  return out;
}

std::array<float, 3> linear(std::array<float, 3> srgb) {
  for (float& v : srgb) v = static_cast<float>(image::linearOfSrgb(v));
  return srgb;
}

/// The solid views of both look the same.
bool sameSolids(const Scene& a, const Scene& b) {
  return a.solidView.width == b.solidView.width && a.solidView.height == b.solidView.height && a.dpr == b.dpr &&
         a.view == b.view && a.projection == b.projection && a.floor == b.floor && a.ground == b.ground &&
         a.meshes == b.meshes;
}

class WebGlRenderer final : public Renderer {
 public:
  ~WebGlRenderer() override {
    if (!lost_) ImGui_ImplOpenGL3_Shutdown();
  }

  bool build() {
    programs_ = makePrograms();
    if (!shadow_.make() || !layer_.make() || !programs_.complete()) return false;
    GLint samples = 0;
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glGetIntegerv(GL_SAMPLES, &samples);
    smoothAnyway_ = samples > 1;
    const float corners[] = {0, 0, 1, 0, 0, 1, 1, 1};
    quadArray_ = VertexArray::make();
    quad_ = Buffer::make();
    glBindVertexArray(quadArray_.name());
    glBindBuffer(GL_ARRAY_BUFFER, quad_.name());
    glBufferData(GL_ARRAY_BUFFER, sizeof corners, corners, GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    glBindVertexArray(0);
    lost_ = false;
    drawn_.forget();
    return ImGui_ImplOpenGL3_Init("#version 300 es");
  }

  void beginUi() override {
    if (!lost_) ImGui_ImplOpenGL3_NewFrame();
  }

  bool drawsOnCanvas(const Scene& scene) const override { return smoothAnyway_ || scene.held; }

  bool finished() override { return lost_ || fence_.passed(); }

  void show() override {
    if (lost_ || !waits_) return;
    waits_ = false;
    glDisable(GL_SCISSOR_TEST);
    frame_.copy(0, 0, 0);
  }

  void draw(const Scene& scene) override {
    if (lost_ || drawn_.shows(scene, ImGui::GetDrawData())) return;
    shadow_.update(scene, meshes_, quadArray_);
    prepareLayer(scene);
    const int width = static_cast<int>(std::lround(scene.width * scene.dpr));
    const int height = static_cast<int>(std::lround(scene.height * scene.dpr));
    glDisable(GL_SCISSOR_TEST);
    clearTo(scene);
    glDepthMask(GL_TRUE);
    beginFrame(scene, width, height);
    glEnable(GL_SCISSOR_TEST);
    showPictureView(scene);
    drawThumbnails(scene);
    drawSolidView(scene);
    glDisable(GL_SCISSOR_TEST);
    glViewport(0, 0, width, height);
    if (ImDrawData* ui = ImGui::GetDrawData()) {
      nameTextures(*ui);
      dropUnseen(*ui);
      ImGui_ImplOpenGL3_RenderDrawData(ui);
    }
    if (waits_) fence_.set();
    meshes_.endFrame();
    textures_.endFrame();
  }

  image::Image snapshot(const Scene& scene) override {
    const int width = static_cast<int>(std::lround(scene.width * scene.dpr));
    const int height = static_cast<int>(std::lround(scene.height * scene.dpr));
    if (lost_) return {};
    shadow_.update(scene, meshes_, quadArray_);
    glDisable(GL_SCISSOR_TEST);
    clearTo(scene);
    glDepthMask(GL_TRUE);
    if (!snapshot_.begin(width, height)) return {};
    if (scene.solidView.width >= 1) {
      drawSolids(scene);
    } else {
      drawPictureView(scene);
    }
    snapshot_.end(0);
    return snapshot_.read();
  }

  void fontsChanged() override {
    if (lost_) return;
    ImGui_ImplOpenGL3_DestroyDeviceObjects();  // made anew with the next frame
    drawn_.forget();
  }

  void contextLost() override {
    if (lost_) return;
    lost_ = true;
    programs_.forget();
    shadow_.forget();
    layer_.forget();
    still_.forget();
    stillPicture_.forget();
    frame_.forget();
    fence_.forget();
    pictureShown_ = {};
    snapshot_.forget();
    quadArray_.forget();
    quad_.forget();
    meshes_.forgetAll();
    textures_.forgetAll();
    // Deleting names of a lost context is harmless; this also clears the backend's own state.
    ImGui_ImplOpenGL3_Shutdown();
  }

  bool contextRestored() override { return !lost_ || build(); }

 private:
  static void clearTo(const Scene& scene) {
    const auto [red, green, blue] = scene.ground.paper;
    glClearColor(red, green, blue, 1);
  }

  /// Clears what the frame is drawn into, and binds it.
  void beginFrame(const Scene& scene, int width, int height) {
    waits_ = !drawsOnCanvas(scene) && frame_.begin(width, height);
    if (waits_) return;
    fence_.remove();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, width, height);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }
  /// Into which the frame is drawn; 0: the canvas.
  GLuint target() const { return waits_ ? frame_.framebuffer() : 0; }

  /// A rectangle of the canvas in device pixels, from its left edge and its foot.
  struct Pixels {
    int left, bottom, width, height;
  };
  static Pixels pixelsOf(const Scene& scene, const Viewport& at) {
    const auto px = [&](double v) { return static_cast<int>(std::lround(v * scene.dpr)); };
    const int left = px(at.x), bottom = px(scene.height) - px(at.y + at.height);
    return {left, bottom, std::max(0, px(at.x + at.width) - left), std::max(0, px(scene.height) - px(at.y) - bottom)};
  }
  /// Viewport and scissor to a rectangle of the canvas.
  void enter(const Scene& scene, const Viewport& at) const {
    const auto [left, bottom, width, height] = pixelsOf(scene, at);
    glViewport(left, bottom, width, height);
    glScissor(left, bottom, width, height);
  }

  /// Addresses of textures become the names that Dear ImGui's backend takes.
  void nameTextures(ImDrawData& ui) {
    const ImTextureID font = ImGui::GetIO().Fonts->TexID;
    for (ImDrawList* list : ui.CmdLists) {
      for (ImDrawCmd& command : list->CmdBuffer) {
        if (command.UserCallback != nullptr || command.TextureId == font) continue;
        const auto name =
            static_cast<std::intptr_t>(textures_.get(*static_cast<const SceneTexture*>(command.TextureId)));
        command.TextureId = reinterpret_cast<ImTextureID>(name);
      }
    }
  }

  void drawQuad() const {
    glBindVertexArray(quadArray_.name());
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glBindVertexArray(0);
  }

  GLint uniform(const Program& program, const char* name) const { return glGetUniformLocation(program.name(), name); }

  /// The quad's place within the current viewport, in clip coordinates.
  void placeQuad(const Program& program, const Viewport& quad, const Viewport& within) const {
    const double left = (quad.x - within.x) / within.width * 2 - 1;
    const double top = 1 - (quad.y - within.y) / within.height * 2;
    glUniform4f(uniform(program, "place"), static_cast<float>(left), static_cast<float>(top),
                static_cast<float>(quad.width / within.width * 2),
                static_cast<float>(-quad.height / within.height * 2));
  }

  /// The picture, with what shows it where it is.
  struct PictureShown {
    SceneTexture picture;
    Viewport at, within;
    double dpr = 0;
    bool operator==(const PictureShown&) const = default;
    bool stands(const PictureShown& o) const { return picture == o.picture && at == o.at && within == o.within; }
  };

  /// A picture that stays where it is is drawn once more, and from then on copied.
  void showPictureView(const Scene& scene) {
    if (smoothAnyway_ || !scene.picture || scene.pictureView.width < 1 || scene.pictureView.height < 1) {
      drawPictureView(scene);
      return;
    }
    const PictureShown shown{*scene.picture, scene.pictureAt, scene.pictureView, scene.dpr};
    const Pixels view = pixelsOf(scene, scene.pictureView);
    const bool stands = shown.stands(pictureShown_);
    pictureKept_ = pictureKept_ && shown == pictureShown_;
    pictureShown_ = shown;
    if (stands && !pictureKept_ && stillPicture_.begin(view.width, view.height)) {
      drawPicture(*scene.picture, scene.pictureAt, scene.pictureView);
      stillPicture_.end(target());
      pictureKept_ = true;
    }
    if (pictureKept_) {
      textures_.get(*scene.picture);  // stays on the GPU
      enter(scene, scene.pictureView);
      stillPicture_.copy(target(), view.left, view.bottom);
    } else {
      drawPictureView(scene);
    }
  }

  void drawPictureView(const Scene& scene) {
    if (!scene.picture || scene.pictureView.width < 1 || scene.pictureView.height < 1) return;
    enter(scene, scene.pictureView);
    drawPicture(*scene.picture, scene.pictureAt, scene.pictureView);
  }

  void drawThumbnails(const Scene& scene) {
    const Viewport& view = scene.thumbnailView;
    if (scene.thumbnails.empty() || view.width < 1 || view.height < 1) return;
    enter(scene, view);
    for (const SceneThumbnail& small : scene.thumbnails) drawPicture(small.texture, small.at, view);
  }

  /// A picture at its place on the canvas, cut off by the viewport that was entered.
  void drawPicture(const SceneTexture& picture, const Viewport& at, const Viewport& within) {
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    const GLuint texture = textures_.get(picture);
    glUseProgram(programs_.picture.name());
    placeQuad(programs_.picture, at, within);
    glUniform2f(uniform(programs_.picture, "sizeOnScreen"), static_cast<float>(at.width),
                static_cast<float>(at.height));
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture);
    glUniform1i(uniform(programs_.picture, "picture"), 0);
    drawQuad();
  }

  /// Where something moves: what stays as it is is drawn into the layer, unless that shows it already.
  void prepareLayer(const Scene& scene) {
    layer_.follow(scene);
    layered_ = false;
    if (smoothAnyway_ || scene.still || (still_ && sameSolids(scene, stillScene_))) return;
    if (scene.solidView.width < 1 || scene.solidView.height < 1) return;
    if (layer_.share()) {
      const Pixels view = pixelsOf(scene, scene.solidView);
      layer_.begin(view.width, view.height);
      drawBackground(scene);
      drawMeshes(scene, layer_.kept());
      layer_.end();
    }
    layered_ = !layer_.kept().empty();
  }

  /// A view that nothing moves in is drawn once, smoothly, and from then on copied, whatever moves beside it.
  void drawSolidView(const Scene& scene) {
    if (scene.solidView.width < 1 || scene.solidView.height < 1) return;
    const Pixels view = pixelsOf(scene, scene.solidView);
    if (still_ && sameSolids(scene, stillScene_)) {
      keepUploads(scene);
    } else if (smoothAnyway_ || !scene.still || !still_.begin(view.width, view.height)) {
      enter(scene, scene.solidView);
      drawMovingView(scene);
      return;
    } else {
      drawSolids(scene);
      still_.end(target());
      stillScene_ = scene;
    }
    enter(scene, scene.solidView);
    still_.copy(target(), view.left, view.bottom);
  }

  void drawMovingView(const Scene& scene) {
    if (layered_) {
      keepUploads(scene);
      const Pixels view = pixelsOf(scene, scene.solidView);
      layer_.draw(view.left, view.bottom, quadArray_);
      drawFloor(scene);
      drawMeshes(scene, layer_.others());
      drawFaint(scene);
    } else {
      drawSolids(scene);
    }
  }

  /// What is taken from a copy stays on the GPU.
  void keepUploads(const Scene& scene) {
    for (const SceneMesh& item : scene.meshes) {
      meshes_.get(item);
      if (item.texture) textures_.get(*item.texture);
    }
  }

  void drawSolids(const Scene& scene) {
    drawBackground(scene);
    drawFloor(scene);
    drawMeshes(scene, scene.meshes);
    drawFaint(scene);
  }

  void drawBackground(const Scene& scene) const {
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glUseProgram(programs_.background.name());
    placeQuad(programs_.background, scene.solidView, scene.solidView);
    glUniform3fv(uniform(programs_.background, "middle"), 1, scene.ground.middle.data());
    glUniform3fv(uniform(programs_.background, "edge"), 1, scene.ground.edge.data());
    drawQuad();
  }

  void drawFloor(const Scene& scene) const {
    if (scene.floor.radius <= 0) return;
    const Mat4 toClip = scene.projection * scene.view;
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    const Program& program = programs_.floor;
    glUseProgram(program.name());
    glUniformMatrix4fv(uniform(program, "toClip"), 1, GL_FALSE, toClip.m.data());
    const auto& [centre, radius, headroom] = scene.floor;
    glUniform4f(uniform(program, "disc"), static_cast<float>(centre.x), static_cast<float>(centre.y),
                static_cast<float>(centre.z), static_cast<float>(radius));
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, shadow_.texture());
    glUniform1i(uniform(program, "shadow"), 0);
    drawQuad();
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
  }

  /// What lies before the planes of meshes, above all else: of each only the nearest surface.
  void drawFaint(const Scene& scene) {
    if (std::ranges::none_of(scene.meshes, fades)) return;
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    drawShare(scene, scene.meshes, Share::Depths);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    drawShare(scene, scene.meshes, Share::Before);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
  }

  /// All but what is faint.
  void drawMeshes(const Scene& scene, std::span<const SceneMesh> meshes) {
    drawShare(scene, meshes, Share::Whole);
    if (std::ranges::any_of(meshes, fades)) drawShare(scene, meshes, Share::Behind);
  }

  /// Meshes without a plane; of those with one what is behind it or before it. The values are the shader's `side`.
  enum class Share : std::int8_t { Behind = -1, Whole, Before, Depths };

  void drawShare(const Scene& scene, std::span<const SceneMesh> meshes, Share share) {
    const bool cut = share != Share::Whole;
    if (cut && !programs_.cut) programs_.cut = makeMeshProgram("#define CUT\n");
    const Mat4 toClip = scene.projection * scene.view;
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    const Program& program = cut ? programs_.cut : programs_.mesh;
    glUseProgram(program.name());
    glCullFace(GL_BACK);
    share == Share::Behind ? glDisable(GL_CULL_FACE) : glEnable(GL_CULL_FACE);  // the inside of an open cut is seen
    glUniformMatrix4fv(uniform(program, "toClip"), 1, GL_FALSE, toClip.m.data());
    glUniformMatrix4fv(uniform(program, "toEye"), 1, GL_FALSE, scene.view.m.data());
    glUniform1i(uniform(program, "picture"), 0);
    const GLint toWorld = uniform(program, "toWorld"), colour = uniform(program, "colour"),
                textured = uniform(program, "textured"), glow = uniform(program, "glow"),
                area = uniform(program, "area"), second = uniform(program, "second"), split = uniform(program, "split"),
                finish = uniform(program, "finish"), plane = uniform(program, "plane");
    if (cut) glUniform1f(uniform(program, "side"), static_cast<float>(share));
    for (const SceneMesh& item : meshes) {
      if (fades(item) != cut) continue;
      const GLuint texture = item.texture ? textures_.get(*item.texture) : 0;
      const GpuMesh& mesh = meshes_.get(item);
      glUniformMatrix4fv(toWorld, 1, GL_FALSE, item.toWorld.m.data());
      glFrontFace(item.flips ? GL_CW : GL_CCW);
      if (item.fadeBefore) glUniform4fv(plane, 1, item.fadeBefore->data());
      glUniform3fv(colour, 1, linear(item.colour).data());
      glUniform1f(textured, texture != 0 ? 1.f : 0.f);
      glUniform1f(glow, item.glow);
      glUniform4fv(area, 1, item.textureArea.data());
      glUniform3fv(second, 1, linear(item.second.value_or(item.colour)).data());
      glUniform1f(split, item.split);
      glUniform1i(finish, static_cast<GLint>(item.finish));
      glActiveTexture(GL_TEXTURE0);
      glBindTexture(GL_TEXTURE_2D, texture);
      glBindVertexArray(mesh.array.name());
      glDrawElements(GL_TRIANGLES, mesh.count, GL_UNSIGNED_INT, nullptr);
    }
    glFrontFace(GL_CCW);
    glBindVertexArray(0);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
  }

  DrawnFrame drawn_;
  Programs programs_;
  FloorShadow shadow_;
  KeptLayer layer_;
  bool layered_ = false;  ///< this frame takes from the layer what stays as it is
  StillTarget still_{kSamples, StillTarget::Depths::Yes}, snapshot_{kSamples, StillTarget::Depths::Yes},
      stillPicture_{0, StillTarget::Depths::No};
  StillTarget frame_{0, StillTarget::Depths::Yes};  ///< where a processor draws: the canvas is given finished frames
  Fence fence_;                                     ///< behind the last frame of those
  bool waits_ = false;                              ///< the last frame was drawn there, and is not on the canvas
  Scene stillScene_;                                ///< whose solid view `still_` shows; what it points to may be gone
  PictureShown pictureShown_;                       ///< in the last frame
  bool pictureKept_ = false;                        ///< `stillPicture_` has it
  bool smoothAnyway_ = false;                       ///< the canvas itself is multisampled, and drawn on
  VertexArray quadArray_;
  Buffer quad_;
  MeshStore meshes_;
  TextureStore textures_;
  bool lost_ = true;
};

}  // namespace

std::unique_ptr<Renderer> makeWebGlRenderer() {
  auto renderer = std::make_unique<WebGlRenderer>();
  if (!renderer->build()) return nullptr;
  return renderer;
}

}  // namespace spineloft::gl
