#include "web/scene/thumbnails.h"

#include <algorithm>

#include "engine/base/hash.h"

namespace spineloft::app {

const image::Image* Thumbnails::small(const document::PictureEntry& entry, const image::Picture& pixels) {
  const auto at = std::ranges::find(slots_, entry.contentHash, &Slot::contentHash);
  if (at != slots_.end()) {
    at->used = true;
    return at->image.get();
  }
  const image::Size size = image::fitSize({pixels.working.width, pixels.working.height}, 1LL << 40, kThumbnailSide);
  auto image = std::make_unique<image::Image>(image::shrink(pixels.working, size.width, size.height));
  slots_.push_back({entry.contentHash, std::move(image), true});
  return slots_.back().image.get();
}

void Thumbnails::addTo(gl::Scene& scene, const document::Document& document, const pipeline::Derived& derived,
                       const UiState& ui) {
  scene.thumbnails.clear();
  const Rect& strip = ui.layout.pictures;
  scene.thumbnailView = {strip.x, strip.y, strip.width, strip.height};
  for (const Thumbnail& wanted : ui.thumbnails) {
    const document::PictureEntry* entry = document::findPicture(document, wanted.picture);
    const image::Picture* pixels = pipeline::pixelsOf(document, derived, wanted.picture);
    if (entry == nullptr || pixels == nullptr) continue;
    const gl::TextureKey key{Hasher().text("thumbnail").number(entry->contentHash).value()};
    const Rect& at = wanted.at;
    scene.thumbnails.push_back({{key, small(*entry, *pixels)}, {at.x, at.y, at.width, at.height}});
  }
  std::erase_if(slots_, [](const Slot& slot) { return !slot.used; });
  for (Slot& slot : slots_) slot.used = false;
}

}  // namespace spineloft::app
