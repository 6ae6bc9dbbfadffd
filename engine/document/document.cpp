#include "engine/document/document.h"

#include <algorithm>

#include "engine/base/hash.h"

namespace spineloft::document {

const PictureEntry* findPicture(const Document& document, PictureId id) {
  const auto at = std::ranges::find(document.pictures, id, &PictureEntry::id);
  return at == document.pictures.end() ? nullptr : &*at;
}

const Part* findPart(const Document& document, PartId id) {
  const auto at = std::ranges::find(document.parts, id, &Part::id);
  return at == document.parts.end() ? nullptr : &*at;
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

}  // namespace spineloft::document
