// The texture of a part.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/image/image.h"
#include "engine/pipeline/part_shape.h"
#include "engine/ribs/base/rib_set.h"
#include "engine/surface/part_texture.h"

namespace spineloft::pipeline {

/// What `pixels`, on which the part was made, show of it (surface::partTexture), its ends and where
/// rib ends are bridged or guessed taken with doubt. `marks`: scribbles of the picture and of the part;
/// those that cover hide what is under them. Null when there is nothing to see of it, or no memory.
std::shared_ptr<const surface::PartTexture> textureStage(const PartShape& shape, const image::Picture& pixels,
                                                         std::array<std::span<const ribs::IgnoreMark>, 2> marks);

/// The same in steps (surface::TextureSteps), on any thread: it holds what it is made from.
class TextureJob {
 public:
  /// Of the texture that the shape wants.
  TextureJob(std::shared_ptr<const PartShape> shape, std::shared_ptr<const image::Picture> pixels,
             std::array<std::span<const ribs::IgnoreMark>, 2> marks);
  /// The next step. False: it was the last.
  bool step();
  /// After the last.
  std::shared_ptr<const surface::PartTexture> texture() const { return made_; }
  TextureKey key() const { return shape_->wantedTexture; }

 private:
  std::shared_ptr<const PartShape> shape_;
  std::shared_ptr<const image::Picture> pixels_;
  std::vector<std::vector<PicturePoint>> sure_, hidden_;
  std::vector<surface::OccludedOutline> occludedStretches_;
  std::optional<surface::TextureSteps> steps_;
  std::shared_ptr<const surface::PartTexture> made_;
};

}  // namespace spineloft::pipeline
