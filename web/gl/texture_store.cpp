#include "web/gl/texture_store.h"

#include <algorithm>

namespace spineloft::gl {
namespace {

constexpr int kMaxTextureSide = 4096;

Texture upload(const image::Image& image) {
  GLint limit = kMaxTextureSide;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  const int side = std::min<int>(limit, kMaxTextureSide);
  const image::Image* pixels = &image;
  image::Image reduced;
  if (image.width > side || image.height > side) {
    const image::Size size = image::fitSize({image.width, image.height}, 1LL << 40, side);
    reduced = image::shrink(image, size.width, size.height);
    pixels = &reduced;
  }
  Texture texture = Texture::make();
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, pixels->width, pixels->height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               pixels->pixels.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

}  // namespace

GLuint TextureStore::get(const SceneTexture& texture) {
  const auto at = std::ranges::find(slots_, texture.key, &Slot::key);
  if (at != slots_.end()) {
    at->used = true;
    return at->texture.name();
  }
  if (texture.image == nullptr || texture.image->empty()) return 0;
  slots_.push_back({texture.key, upload(*texture.image), true});
  return slots_.back().texture.name();
}

void TextureStore::endFrame() {
  std::erase_if(slots_, [](const Slot& slot) { return !slot.used; });
  for (Slot& slot : slots_) slot.used = false;
}

void TextureStore::forgetAll() {
  for (Slot& slot : slots_) slot.texture.forget();
  slots_.clear();
}

}  // namespace spineloft::gl
