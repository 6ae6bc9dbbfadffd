// Small pictures of parts, for their rows in the list.
#pragma once

#include <memory>
#include <vector>

#include "engine/document/document.h"
#include "engine/pipeline/derive.h"
#include "web/gl/renderer.h"

namespace spineloft::app {

inline constexpr int kPartPictureSide = 64;  ///< pixels: sharp on any screen

/// The mesh from the front, as drawn and not as placed, whole in a square of kPartPictureSide with nothing round it.
/// It has its texture, or `pixels` of its picture where that is not made yet (null: none), or the colours of its look.
/// Empty for a mesh without extent. Cost: O(triangles + pixels).
image::Image partPicture(const pipeline::PartShape& shape, const document::Look& look, const image::Image* pixels);

class PartPictures {
 public:
  /// The picture of a part, made once for each shape and look; null while it has no shape. Valid until `forgetUnused`.
  const gl::SceneTexture* of(const document::Document& document, const pipeline::Derived& derived,
                             const document::Part& part);
  /// Once a frame, when it was drawn: forgets what was not asked for in it.
  void forgetUnused();

 private:
  struct Slot {
    gl::SceneTexture texture;
    image::Image image;
    bool used = true;
  };
  std::vector<std::unique_ptr<Slot>> slots_;
};

}  // namespace spineloft::app
