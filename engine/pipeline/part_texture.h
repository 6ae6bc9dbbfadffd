// The picture as a part wears it.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "engine/image/image.h"
#include "engine/pipeline/part_shape.h"
#include "engine/ribs/ribs.h"
#include "engine/surface/part_texture.h"

namespace spineloft::pipeline {

/// What `pixels`, on which the part was made, show of it (surface::partTexture), its ends and where
/// rib ends are bridged or guessed taken with doubt. `marks`: scribbles of the picture and of the part;
/// those that cover hide what is under them. Null when there is nothing to see of it, or no memory.
std::shared_ptr<const surface::PartTexture> textureStage(
    const PartShape& shape, const image::Picture& pixels,
    std::array<std::span<const ribs::IgnoreMark>, 2> marks);

}  // namespace spineloft::pipeline
