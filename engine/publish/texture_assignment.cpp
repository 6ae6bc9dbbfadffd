#include "engine/publish/texture_assignment.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/mesh/laws.h"
#include "engine/surface/atlas.h"
#include "engine/surface/finish.h"

namespace spineloft::publish {
namespace {

/// Rows of the tile of a part in two colours: enough that their border looks sharp.
constexpr int kTileRows = 64, kTileColumns = 4;

image::Image twoTone(const document::Look& look) {
  image::Image tile{kTileColumns, kTileRows, {}};
  for (int y = 0; y < kTileRows; ++y) {
    const auto& colour = 2 * y < kTileRows ? look.colour : look.second;
    for (int x = 0; x < kTileColumns; ++x) {
      tile.pixels.insert(tile.pixels.end(), colour.begin(), colour.end());
      tile.pixels.push_back(255);
    }
  }
  return tile;
}

/// A part's own texture, and where on it a vertex is.
struct Cloth {
  std::size_t part = 0;
  const image::Image* pixels = nullptr;
  bool painted = false;  ///< two colours, by height; else the picture
};

/// The mesh by whose height two colours lie: the part's own, before it was turned. Faces of a solid have none
/// but themselves.
const mesh::TriMesh& uprightOf(const UntexturedPart& untextured) {
  return untextured.upright != nullptr ? *untextured.upright : *untextured.mesh;
}

std::array<double, 2> placeOf(const UntexturedPart& untextured, const Cloth& cloth, std::size_t vertex,
                              const mesh::Bounds& bounds) {
  if (cloth.painted) {
    const double low = bounds.low[1], high = bounds.high[1];
    const double y = static_cast<double>(uprightOf(untextured).positions[vertex][1]);
    return {0.5, high > low ? std::clamp((high - y) / (high - low), 0.0, 1.0) : 0.5};
  }
  const surface::UvArea& area = untextured.shape->texture->area;
  const auto [u, v] = untextured.mesh->uv[vertex];
  return {std::clamp((static_cast<double>(u) - area.left) / (area.right - area.left), 0.0, 1.0),
          std::clamp((static_cast<double>(v) - area.top) / (area.bottom - area.top), 0.0, 1.0)};
}

mesh::TriMesh remapped(const UntexturedPart& untextured, const Cloth& cloth, const surface::UvArea& place) {
  mesh::TriMesh mesh = *untextured.mesh;
  const mesh::Bounds bounds = mesh::boundsOf(uprightOf(untextured));  // in its own space
  mesh.uv.resize(mesh.positions.size());
  for (std::size_t v = 0; v < mesh.uv.size(); ++v) {
    const auto [x, y] = placeOf(untextured, cloth, v, bounds);
    mesh.uv[v] = surface::inAtlas(place, x, y);
  }
  return mesh;
}

}  // namespace

TextureAssignment assignTextures(std::span<const UntexturedPart> parts, bool pictures) {
  TextureAssignment out;
  std::vector<Cloth> cloths;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const UntexturedPart& untextured = parts[i];
    const document::Look& look = *untextured.look;
    io::ExportPart& part = *untextured.part;
    part.mesh = untextured.mesh;
    for (std::size_t c = 0; c < 3; ++c) part.colour[c] = static_cast<float>(look.colour[c]) / 255.0f;
    part.faceted = look.faceted;
    const surface::Finish& finish = surface::finishOf(look.textured ? surface::Paint::Plain : look.paint);
    part.roughness = finish.roughness;
    part.metallic = finish.metallic;
    if (!pictures) continue;
    if (look.textured && untextured.shape != nullptr && untextured.shape->texture != nullptr &&
        untextured.mesh->uv.size() == untextured.mesh->positions.size()) {
      cloths.push_back({i, &untextured.shape->texture->pixels, false});
    } else if (!look.textured && look.paint == surface::Paint::TwoTone) {
      out.tiles.push_back(twoTone(look));
      cloths.push_back({i, &out.tiles.back(), true});
    }
  }
  std::vector<const image::Image*> images;
  for (const Cloth& cloth : cloths) images.push_back(cloth.pixels);
  std::optional<surface::Atlas> atlas = surface::packAtlas(images);
  if (!atlas) return out;
  for (std::size_t i = 0; i < cloths.size(); ++i) {
    const UntexturedPart& untextured = parts[cloths[i].part];
    out.meshes.push_back(remapped(untextured, cloths[i], atlas->places[i]));
    untextured.part->mesh = &out.meshes.back();
    untextured.part->picture = 0;
  }
  out.atlas = std::move(atlas->pixels);
  return out;
}

}  // namespace spineloft::publish
