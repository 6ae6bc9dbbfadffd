// Pictures on the GPU: sRGB, mipmapped, at most 4096 pixels a side, one upload a key.
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
