#include "engine/pipeline/cache.h"

#include <algorithm>

#include "engine/inflate/interior.h"
#include "engine/pull/pull.h"
#include "engine/relief/heights.h"
#include "engine/relief/raise.h"

namespace spineloft::pipeline {

std::shared_ptr<const image::EdgeMap> Cache::edges(std::uint64_t contentHash) const {
  const auto at = std::ranges::find(edges_, contentHash, &EdgeSlot::contentHash);
  return at == edges_.end() ? nullptr : at->edges;
}

void Cache::keepEdges(std::uint64_t contentHash, std::shared_ptr<const image::EdgeMap> edges) {
  std::erase_if(edges_, [&](const EdgeSlot& slot) { return slot.contentHash == contentHash; });
  edges_.push_back({contentHash, std::move(edges)});
}

void Cache::keepIgnored(IgnoredKey key, std::shared_ptr<const ribs::IgnoredEdges> ignored) {
  const std::size_t bytes = bytesOf(*ignored);
  ignored_.keep(key, std::move(ignored), bytes);
}

std::shared_ptr<const TracedRibs> Cache::traced(TraceKey key) {
  auto known = traced_.find(key);
  return known ? known : previews_.find(key);
}

void Cache::keepTraced(TraceKey key, std::shared_ptr<const TracedRibs> traced, bool isPreview) {
  const std::size_t bytes = bytesOf(*traced);
  (isPreview ? previews_ : traced_).keep(key, std::move(traced), bytes);
}

void Cache::keepInterior(InteriorKey key, KnownInterior interior) {
  const std::size_t bytes = inflate::bytesOf(*interior);
  interiors_.keep(key, std::move(interior), bytes);
}

void Cache::keepDrawing(DrawingKey key, std::shared_ptr<const DrawingShape> drawing) {
  const std::size_t bytes = bytesOf(*drawing);
  drawings_.keep(key, std::move(drawing), bytes);
}

void Cache::keepHeights(HeightsKey key, std::shared_ptr<const relief::Heights> heights) {
  const std::size_t bytes = relief::bytesOf(*heights);
  heights_.keep(key, std::move(heights), bytes);
}

void Cache::keepRaised(RaisedKey key, std::shared_ptr<const relief::Raised> raised) {
  const std::size_t bytes = relief::bytesOf(*raised);
  raised_.keep(key, std::move(raised), bytes);
}

std::shared_ptr<const PartShape> Cache::shape(ShapeKey key) {
  for (ShapeSlot& slot : shapes_) {
    if (slot.shape->key == key) {
      slot.lastRound = round_;
      return slot.shape;
    }
  }
  return nullptr;
}

void Cache::keepShape(std::shared_ptr<const PartShape> shape) {
  const std::size_t bytes = bytesOf(*shape);
  shapes_.push_back({std::move(shape), round_, bytes});
}

std::shared_ptr<const PartShape> Cache::wantTexture(ShapeKey key, TextureKey wanted) {
  for (ShapeSlot& slot : shapes_) {
    if (slot.shape->key != key) continue;
    if (slot.shape->wantedTexture != wanted) {
      auto wanting = std::make_shared<PartShape>(*slot.shape);
      wanting->wantedTexture = wanted;
      slot.shape = std::move(wanting);
    }
    return slot.shape;
  }
  return nullptr;
}

std::shared_ptr<const PartShape> Cache::assignTexture(TextureKey key,
                                                      std::shared_ptr<const surface::PartTexture> texture) {
  for (ShapeSlot& slot : shapes_) {
    if (slot.shape->wantedTexture != key) continue;
    auto textured = std::make_shared<PartShape>(*slot.shape);
    textured->texture = std::move(texture);
    textured->textureKey = key;
    slot.bytes = bytesOf(*textured);
    slot.shape = std::move(textured);
    return slot.shape;
  }
  return nullptr;
}

Result<std::shared_ptr<const image::Picture>> Cache::pixels(const document::PictureEntry& entry) {
  if (!entry.isSketch()) return entry.picture;
  const auto at = std::ranges::find(sketches_, entry.contentHash, &SketchSlot::contentHash);
  if (at != sketches_.end()) return at->picture;
  // The most of it that is drawn already: as a rule everything but the last stroke.
  const SketchSlot* begun = nullptr;
  for (const SketchSlot& slot : sketches_) {
    const std::size_t known = slot.strokes.size();
    const image::Size size{slot.picture->width, slot.picture->height};
    if (size != entry.size || known > entry.sketch.size()) continue;
    if (begun && known <= begun->strokes.size()) continue;
    if (std::equal(slot.strokes.begin(), slot.strokes.end(), entry.sketch.begin())) begun = &slot;
  }
  const std::span<const Box<image::SketchStroke>> strokes(entry.sketch);
  Result<image::Picture> drawn = begun ? image::drawMore(*begun->picture, strokes.subspan(begun->strokes.size()))
                                       : image::drawSketch(entry.size, strokes);
  if (!drawn) return drawn.failure();
  auto picture = std::make_shared<const image::Picture>(std::move(drawn).value());
  sketches_.push_back({entry.contentHash, entry.sketch, picture});
  return picture;
}

void Cache::keepUnpulled(ShapeKey key, std::shared_ptr<const PartShape> shape) {
  const std::size_t bytes = bytesOf(*shape);
  unpulled_.keep(key, std::move(shape), bytes);
}

void Cache::keepReach(ReachKey key, std::shared_ptr<const pull::Reach> reach) {
  const mesh::TriMesh& mesh = reach->mesh;
  const auto bytes = [](const auto& vector) { return vector.size() * sizeof(vector[0]); };
  const std::size_t size = sizeof(*reach) + bytes(mesh.positions) + bytes(mesh.uv) + bytes(mesh.triangles) +
                           bytes(reach->moved) + bytes(reach->line) + bytes(reach->ring);
  reaches_.keep(key, std::move(reach), size);
}

void Cache::endRound(const std::vector<std::uint64_t>& usedEdges) {
  std::ranges::stable_sort(shapes_, std::ranges::greater{}, &ShapeSlot::lastRound);
  std::size_t bytes = 0;
  std::erase_if(shapes_, [&](const ShapeSlot& slot) {
    bytes += slot.bytes;
    const bool fits = bytes <= kShapeBytes && slot.lastRound + kKeptRounds > round_;
    return slot.lastRound != round_ && !fits;
  });
  ++round_;
  const auto unused = [&](const auto& slot) {
    return std::ranges::find(usedEdges, slot.contentHash) == usedEdges.end();
  };
  std::erase_if(edges_, unused);
  // Sketches as they were a few strokes ago: undo and the next stroke begin with them.
  std::size_t kept = 0;
  std::ranges::reverse(sketches_);
  std::erase_if(sketches_, [&](const SketchSlot& slot) {
    if (!unused(slot)) return false;
    kept += slot.picture->working.pixels.size();
    return kept > kSketchBytes;
  });
  std::ranges::reverse(sketches_);
}

std::size_t Cache::bytes() const {
  std::size_t sum = ignored_.bytes() + traced_.bytes() + previews_.bytes() + interiors_.bytes() + drawings_.bytes() +
                    unpulled_.bytes() + reaches_.bytes() + heights_.bytes() + raised_.bytes();
  for (const ShapeSlot& slot : shapes_) sum += slot.bytes;
  return sum;
}

}  // namespace spineloft::pipeline
