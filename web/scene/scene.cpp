#include "web/scene/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>

#include "engine/base/hash.h"
#include "engine/mesh/laws.h"
#include "engine/publish/publish.h"
#include "web/edit/drawn_rail.h"
#include "web/edit/hollowing.h"
#include "web/edit/layers.h"
#include "web/edit/placing.h"
#include "web/edit/preview.h"

namespace spineloft::app {
namespace {

gl::Viewport viewport(const Rect& rect) { return {rect.x, rect.y, rect.width, rect.height}; }

std::array<float, 3> colourOf(std::uint32_t colour) {
  const auto channel = [&](unsigned shift) { return static_cast<float>((colour >> shift) & 255u) / 255.f; };
  return {channel(0), channel(8), channel(16)};
}

gl::SceneTexture textureOf(const document::PictureEntry& entry, const image::Picture& pixels) {
  return {{Hasher().text("picture").number(entry.contentHash).value()}, &pixels.working};
}

gl::Mat4 matrixOf(const pipeline::ToWorld& toWorld) {
  gl::Mat4 out;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      out.m[4 * column + row] = static_cast<float>(toWorld.linear[3 * row + column]);
    }
  }
  const WorldPoint shift = toWorld(ModelPoint{});
  out.m[12] = static_cast<float>(shift.x);
  out.m[13] = static_cast<float>(shift.y);
  out.m[14] = static_cast<float>(shift.z);
  return out;
}

/// The sheet of the tool Layers in the world, and whose it is.
struct Cut {
  PartId part;                 ///< none: the next part's
  std::array<float, 4> plane;  ///< gl::SceneMesh::fadeBefore; the eye is before it
  double least = 0;            ///< world units of a mesh on both sides, where the sheet is in its middle
};

std::optional<Cut> cutOf(const document::Document& document, const pipeline::Derived& derived, const UiState& ui) {
  const std::optional<Sheet> sheet = sheetInHand(document, ui);
  // While a hand moves the sheet the solid stays as it is drawn: to draw it anew takes a processor without a GPU long.
  if (!sheet || ui.layers.held != SheetHold::Nothing || drawsRail(document, ui) || ui.fliesAlong()) {
    return std::nullopt;
  }
  constexpr double kLeast = 0.02;  // of the sheet's half side
  const pipeline::ToWorld toWorld = sheetInWorld(document, derived, ui, *sheet);
  const WorldPoint at = toWorld(sheet->stand.origin);
  WorldPoint normal = toWorld.along(sheet->stand.normal()) / toWorld.scale;
  if (dot(normal, ui.camera.eye() - at) < 0) normal = normal * -1;
  const auto f = [](double v) { return static_cast<float>(v); };
  return Cut{
      sheet->part, {f(normal.x), f(normal.y), f(normal.z), f(dot(normal, at))}, kLeast * sheet->half * toWorld.scale};
}

/// What of the part hides its sheet is faint: the mesh, if the sheet is in its middle.
void fade(const std::optional<Cut>& cut, PartId part, gl::SceneMesh& mesh) {
  if (!cut || cut->part != part) return;
  const auto& m = mesh.toWorld.m;
  const auto& n = cut->plane;
  const auto along = [&](std::size_t column) {
    return n[0] * m[4 * column] + n[1] * m[4 * column + 1] + n[2] * m[4 * column + 2];
  };
  const float x = along(0), y = along(1), z = along(2), shift = along(3) - n[3];
  bool before = false, behind = false;
  for (const auto& p : mesh.mesh->positions) {
    const float far = x * p[0] + y * p[1] + z * p[2] + shift;
    before = before || far > cut->least;
    behind = behind || far < -cut->least;
    if (!before || !behind) continue;
    mesh.fadeBefore = n;
    return;
  }
}

/// The part's mesh as often as it is seen; its sheet stands in the first one.
void addCopies(gl::SceneMesh mesh, PartId part, const pipeline::Copies& copies, const std::optional<Cut>& cut,
               gl::Scene& scene) {
  for (const pipeline::ToWorld& toWorld : copies) {
    mesh.toWorld = matrixOf(toWorld);
    mesh.flips = toWorld.flips;
    mesh.fadeBefore.reset();
    if (&toWorld == copies.begin()) fade(cut, part, mesh);
    scene.meshes.push_back(mesh);
  }
}

/// Where a picture's parts get their surface from.
struct Source {
  const document::PictureEntry* entry = nullptr;
  const image::Picture* pixels = nullptr;  ///< null: none
};

Source sourceOf(const document::Document& document, const pipeline::Derived& derived, PictureId id) {
  return {document::findPicture(document, id), pipeline::pixelsOf(document, derived, id)};
}

/// A finished shape has a texture of its own; one in hand, or whose texture is being made, that of an
/// earlier one or the picture itself.
void useTexture(const Source& source, const pipeline::PartShape& shape, gl::SceneMesh& mesh) {
  if (shape.texture) {
    const surface::UvArea& area = shape.texture->area;
    const gl::TextureKey key{Hasher().text("texture").number(shape.textureKey.hash).value()};
    mesh.texture = {key, &shape.texture->pixels};
    mesh.textureArea = {static_cast<float>(area.left), static_cast<float>(area.top),
                        static_cast<float>(area.right - area.left), static_cast<float>(area.bottom - area.top)};
  } else if (!isTextureKnown(shape) && source.pixels) {
    mesh.texture = textureOf(*source.entry, *source.pixels);
  }
}

std::array<float, 3> shares(const std::array<std::uint8_t, 3>& colour) {
  std::array<float, 3> out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = static_cast<float>(colour[i]) / 255.f;
  return out;
}

void paint(const document::Look& look, const mesh::TriMesh& solid, gl::SceneMesh& mesh) {
  switch (look.paint) {
    case surface::Paint::TwoTone: {
      const mesh::Bounds bounds = mesh::boundsOf(solid);
      mesh.second = shares(look.second);
      mesh.split = static_cast<float>((bounds.low[1] + bounds.high[1]) / 2);
      break;
    }
    case surface::Paint::Clay:
      mesh.finish = gl::Finish::Clay;
      break;
    case surface::Paint::Glaze:
      mesh.finish = gl::Finish::Glaze;
      break;
    case surface::Paint::Metal:
      mesh.finish = gl::Finish::Metal;
      break;
    case surface::Paint::Plain:
    case surface::Paint::kCount:
      break;
  }
}

gl::SceneMesh meshOf(const Source& source, const document::Look& look, const pipeline::PartShape& shape) {
  gl::SceneMesh mesh;
  mesh.mesh = &shape.mesh;
  if (look.textured) useTexture(source, shape, mesh);
  mesh.colour = shares(look.colour);
  mesh.faceted = look.faceted;
  if (!look.textured) paint(look, *mesh.mesh, mesh);
  return mesh;
}

/// Of the mesh as it lies on the GPU. `what` is of which kind `hash` is.
gl::MeshKey meshKey(std::string_view what, std::uint64_t hash, bool faceted) {
  return {Hasher().text(what).number(hash).number(faceted).value()};
}

void addParts(const document::Document& document, const pipeline::Derived& derived, const UiState& ui,
              const std::optional<Cut>& cut, gl::Scene& scene) {
  const std::size_t count = std::min(document.parts.size(), derived.parts.size());
  for (std::size_t i = 0; i < count; ++i) {
    const document::Part& part = document.parts[i];
    const auto& shape = derived.parts[i].shape;
    const Source source = sourceOf(document, derived, document::pictureOf(part));
    if (!shape || !showsItself(document, derived, part) || source.entry == nullptr) continue;
    if (previewOf(ui, part.id)) continue;
    gl::SceneMesh mesh = meshOf(source, part.look, *shape);
    mesh.key = meshKey("shape", shape->key.hash, mesh.faceted);
    const bool several = document.parts.size() > 1;
    const bool lit = ui.solids.hollow ? becomesHollow(document, ui, part.id) : isSelected(document, ui, part.id);
    mesh.glow = several && lit ? 1.f : several && part.id == ui.hover.part ? 0.45f : 0.f;
    addCopies(mesh, part.id, shownCopies(ui, part, source.entry->size), cut, scene);
  }
}

/// The faces of a solid look as the parts they come from.
gl::SceneMesh pieceOf(const document::Document& document, const pipeline::Derived& derived, const document::Step& step,
                      const pipeline::SolidPiece& piece) {
  gl::SceneMesh mesh;
  mesh.mesh = &piece.mesh;
  const auto at =
      std::ranges::find_if(document.parts, [&](const document::Part& part) { return part.id == piece.part; });
  document::Look look = step.look;
  if (at != document.parts.end()) {
    const auto index = static_cast<std::size_t>(at - document.parts.begin());
    const document::Part& part = *at;
    if (!step.ownLook) look = part.look;
    const Source source = sourceOf(document, derived, document::pictureOf(part));
    const bool known = index < derived.parts.size() && derived.parts[index].shape;
    if (look.textured && known && source.entry != nullptr) {
      useTexture(source, *derived.parts[index].shape, mesh);
    }
  }
  mesh.colour = shares(look.colour);
  mesh.faceted = look.faceted;
  if (!look.textured) paint(look, *mesh.mesh, mesh);
  return mesh;
}

void addSolids(const document::Document& document, const pipeline::Derived& derived, const UiState& ui,
               const std::optional<Cut>& cut, gl::Scene& scene) {
  for (const document::Step& step : document.steps) {
    const pipeline::DerivedStep* shown = shownSolid(document, derived, step);
    if (shown == nullptr) continue;
    std::size_t number = 0;
    for (const pipeline::SolidPiece& piece : shown->solid->pieces) {
      gl::SceneMesh mesh = pieceOf(document, derived, step, piece);
      const Hasher place = Hasher().number(shown->solid->key.hash).number(number++);
      mesh.key = meshKey("piece", place.value(), mesh.faceted);
      const bool chosen =
          piece.part && (ui.solids.hollow ? becomesHollow(document, ui, piece.part) : piece.part == ui.selection);
      mesh.glow = chosen ? 0.7f : piece.part && piece.part == ui.hover.part ? 0.35f : 0.f;
      const std::optional<Flash>& flash = ui.solids.flash;
      if (flash && flash->step == step.id) mesh.glow = std::max(mesh.glow, static_cast<float>(flash->light));
      if (piece.part) fade(cut, piece.part, mesh);
      scene.meshes.push_back(mesh);
    }
  }
}

void addPreview(const document::Document& document, const pipeline::Derived& derived, const UiState& ui,
                const std::optional<Cut>& cut, gl::Scene& scene) {
  if (!ui.preview || !ui.preview->shape) return;
  const Preview& preview = *ui.preview;
  if (solidOf(document, derived, preview.part) != nullptr) return;  // it changes the solid instead
  const Source source = sourceOf(document, derived, document::pictureOf(preview.recipe));
  if (source.entry == nullptr) return;
  gl::SceneMesh mesh = meshOf(source, preview.look, *preview.shape);
  mesh.key = meshKey("preview", preview.revision, mesh.faceted);
  addCopies(mesh, preview.part, previewCopies(document, derived, ui, source.entry->size), cut, scene);
}

/// The next of the sizes that the floor has, which are a twelfth apart: small changes of a part leave it alone.
double floorSize(double least) { return std::exp2(std::ceil(8 * std::log2(least)) / 8); }

/// The floor lies just below the lowest part. In a hurried frame that of the frame before stays while it is about as
/// large: with another one its shadow would be drawn anew.
void addFloor(gl::Scene& scene) {
  const gl::Floor before = std::exchange(scene.floor, {});
  WorldPoint low{1e30, 1e30, 1e30}, high{-1e30, -1e30, -1e30};
  for (const gl::SceneMesh& mesh : scene.meshes) {
    const auto& m = mesh.toWorld.m;
    for (const auto& p : mesh.mesh->positions) {
      const WorldPoint w{m[0] * p[0] + m[4] * p[1] + m[8] * p[2] + m[12],
                         m[1] * p[0] + m[5] * p[1] + m[9] * p[2] + m[13],
                         m[2] * p[0] + m[6] * p[1] + m[10] * p[2] + m[14]};
      low = {std::min(low.x, w.x), std::min(low.y, w.y), std::min(low.z, w.z)};
      high = {std::max(high.x, w.x), std::max(high.y, w.y), std::max(high.z, w.z)};
    }
  }
  if (!(low.x <= high.x)) return;
  const WorldPoint size = high - low;
  const double radius = floorSize(std::max({size.x, size.z, size.y * 0.85, 0.1}) * 0.75), step = radius / 16;
  const auto middle = [&](double from, double to) { return std::round((from + to) / 2 / step) * step; };
  scene.floor = {
      {middle(low.x, high.x), low.y - 0.002, middle(low.z, high.z)}, radius, floorSize(std::max(size.y * 0.85, 0.05))};
  constexpr double kSmallest = 0.5, kLargest = 1.5;  // times that of the frame before
  const double times = before.radius > 0 ? scene.floor.radius / before.radius : 0;
  if (scene.hurried && times >= kSmallest && times <= kLargest) scene.floor = before;
}

}  // namespace

void buildScene(const document::Document& document, const pipeline::Derived& derived, const UiState& ui,
                gl::Scene& scene) {
  scene.width = ui.canvasWidth;
  scene.height = ui.canvasHeight;
  scene.dpr = ui.dpr;
  scene.ground = {colourOf(ui.palette.paper), colourOf(ui.palette.ground), colourOf(ui.palette.groundEdge)};
  scene.pictureView = viewport(ui.layout.picture);
  scene.solidView = viewport(ui.layout.solid);
  scene.picture.reset();
  const Source shown = sourceOf(document, derived, ui.picture);
  if (shown.entry != nullptr && shown.pixels != nullptr) {
    scene.picture = textureOf(*shown.entry, *shown.pixels);
    scene.pictureAt = viewport(pictureRect(ui.pictureView, shown.entry->size, ui.layout.picture));
  }
  scene.view = viewOf(ui.camera);
  scene.projection = projectionOf(ui.camera, ui.layout.solid);
  scene.meshes.clear();
  const std::optional<Cut> cut = cutOf(document, derived, ui);
  addParts(document, derived, ui, cut, scene);
  addSolids(document, derived, ui, cut, scene);
  addPreview(document, derived, ui, cut, scene);
  addFloor(scene);
}

}  // namespace spineloft::app
