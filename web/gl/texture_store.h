// Pictures on the GPU: mipmapped, at most 4096 pixels a side, one upload a key. They are sampled and made smaller by
// their sRGB values, as image::shrink does: where a processor draws, mipmaps of an sRGB texture take three times as
// long.
#pragma once

#include <vector>

#include "web/gl/handles.h"
#include "web/gl/renderer.h"

namespace spineloft::gl {

class TextureStore {
 public:
  /// The texture's name, uploaded now if it is new.
  GLuint get(const SceneTexture& texture);
  /// Deletes what was not asked for since the last call.
  void endFrame();
  /// The context is lost: forgets every name.
  void forgetAll();

 private:
  struct Slot {
    TextureKey key;
    Texture texture;
    bool used = true;
  };
  std::vector<Slot> slots_;
};

}  // namespace spineloft::gl
