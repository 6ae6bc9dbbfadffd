#include "engine/document/document.h"

#include <algorithm>

#include "engine/base/hash.h"

namespace spineloft::document {

const PictureEntry* findPicture(const Document& document, PictureId id) {
  const auto at = std::ranges::find_if(
      document.pictures, [&](const PictureEntry& entry) { return entry.id == id; });
  return at == document.pictures.end() ? nullptr : &at->get();
}

const Part* findPart(const Document& document, PartId id) {
  const auto at = std::ranges::find_if(document.parts,
                                       [&](const Part& part) { return part.id == id; });
  return at == document.parts.end() ? nullptr : &at->get();
}

std::uint64_t contentHash(const image::Picture& picture) {
  return Hasher()
      .number(picture.width)
      .number(picture.height)
      .number(picture.working.width)
      .number(picture.working.height)
      .bytes(std::as_bytes(std::span(picture.working.pixels)))
      .value();
}

std::uint64_t contentHash(image::Size size, std::span<const Box<image::SketchStroke>> sketch) {
  Hasher hasher;
  hasher.text("sketch").number(size.width).number(size.height).number(sketch.size());
  for (const image::SketchStroke& stroke : sketch) {
    const auto& [points, pressure, radius, erase, colour] = stroke;
    hasher.number(points.size()).number(pressure.size()).number(radius).number(erase);
    for (const PicturePoint& p : points) hasher.number(p.x).number(p.y);
    for (const float value : pressure) hasher.number(value);
    for (const std::uint8_t value : colour) hasher.number(value);
  }
  return hasher.value();
}

}  // namespace spineloft::document
