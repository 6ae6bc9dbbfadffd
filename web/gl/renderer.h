// What is drawn, as plain values, and who draws it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/base/cache_key.h"
#include "engine/image/image.h"
#include "engine/mesh/tri_mesh.h"
#include "web/gl/mat4.h"

namespace spineloft::gl {

/// A rectangle in CSS pixels from the canvas' top left corner.
struct Viewport {
  double x = 0, y = 0, width = 0, height = 0;
  bool operator==(const Viewport&) const = default;
};

using TextureKey = CacheKey<struct TextureKeyTag>;  ///< of pixels on the GPU
using MeshKey = CacheKey<struct MeshKeyTag>;        ///< of geometry on the GPU

/// Pixels that may lie on the GPU under `key`, which is never none. Texture ids of Dear ImGui, but for that of its
/// font, are addresses of a SceneTexture that lives while the frame is drawn.
struct SceneTexture {
  TextureKey key;
  const image::Image* image = nullptr;
  bool operator==(const SceneTexture&) const = default;
};

/// How a surface takes the light.
enum class Finish : std::uint8_t { Plain, Clay, Glaze, Metal };

struct SceneMesh {
  MeshKey key;                          ///< never none
  const mesh::TriMesh* mesh = nullptr;  ///< alive while the scene is drawn
  Mat4 toWorld;                         ///< a turn or mirror, a uniform scale and a shift
  bool flips = false;                   ///< `toWorld` mirrors
  std::optional<SceneTexture> texture;  ///< else `colour` alone
  /// What of the mesh's UV the texture covers: left, top, width, height.
  std::array<float, 4> textureArea{0, 0, 1, 1};
  std::array<float, 3> colour{1, 1, 1};  ///< sRGB, 0…1
  /// A second colour below `split`, a height in the mesh's own space.
  std::optional<std::array<float, 3>> second;
  float split = 0;
  Finish finish = Finish::Plain;
  bool faceted = false;  ///< every triangle flat; part of `key`
  float glow = 0;        ///< 0…1: how much it is lit
  /// A unit normal n of the world and an offset d: what lies before that plane, n · p > d, is drawn faint, and the open
  /// cut that this leaves looks like a section.
  std::optional<std::array<float, 4>> fadeBefore;
  bool operator==(const SceneMesh&) const = default;
};

/// A small picture within the strip of pictures.
struct SceneThumbnail {
  SceneTexture texture;
  Viewport at;
  bool operator==(const SceneThumbnail&) const = default;
};

/// The disc that the parts stand on.
struct Floor {
  WorldPoint centre;    ///< a point on it
  double radius = 0;    ///< 0: no floor
  double headroom = 1;  ///< height above it within which parts cast shadows
  bool operator==(const Floor&) const = default;
};

/// Colours, sRGB 0…1; as they are here the page is light.
struct Ground {
  std::array<float, 3> paper = {0.969f, 0.961f, 0.941f};                                    ///< where nothing is drawn
  std::array<float, 3> middle = {0.988f, 0.984f, 0.973f}, edge = {0.925f, 0.914f, 0.886f};  ///< of the solid view
  bool operator==(const Ground&) const = default;
};

/// Everything below the panels of one frame.
struct Scene {
  double width = 0, height = 0, dpr = 1;  ///< of the canvas, CSS pixels
  Viewport pictureView, solidView;
  std::optional<SceneTexture> picture;
  Viewport pictureAt;  ///< where the whole picture lies; may reach beyond its view
  std::vector<SceneThumbnail> thumbnails;
  Viewport thumbnailView;  ///< what is outside of it is cut off
  Mat4 view, projection;
  Floor floor;
  std::vector<SceneMesh> meshes;
  Ground ground;       ///< of a snapshot it is always light
  bool still = false;  ///< nothing moves: this frame may take longer and look better
  bool held = false;   ///< a hand waits for this frame, which is about as soon drawn as those before
  /// A processor draws it for a hand that moves: the floor and its shadow stay while they are about as large.
  bool hurried = false;
  bool operator==(const Scene&) const = default;
};

class Renderer {
 public:
  virtual ~Renderer() = default;
  /// Before ImGui's new frame: makes sure its textures exist.
  virtual void beginUi() = 0;
  /// Whether the frame will be drawn on the canvas itself, which has its pixels by then. Others are drawn beside it,
  /// and it has their pixels when they are shown: a canvas that is still being drawn holds up the page.
  virtual bool drawsOnCanvas(const Scene& scene) const = 0;
  /// Draws the scene and, above it, ImGui's finished draw data; nothing where that was drawn last.
  virtual void draw(const Scene& scene) = 0;
  /// Whether the last frame can be shown: it was drawn on the canvas, or all of it has been drawn.
  virtual bool finished() = 0;
  /// The canvas, with as many pixels as the last frame, shows it.
  virtual void show() = 0;
  /// The scene's solid view, or its picture view where that is empty, as pixels of the canvas' size,
  /// smooth and without panels; the canvas stays as it is. Empty when it cannot be drawn.
  virtual image::Image snapshot(const Scene& scene) = 0;
  /// The font atlas of ImGui was rebuilt.
  virtual void fontsChanged() = 0;
  /// Every object on the GPU is gone; nothing is drawn until `contextRestored`.
  virtual void contextLost() = 0;
  /// Makes everything again; false when that failed.
  virtual bool contextRestored() = 0;
};

}  // namespace spineloft::gl
