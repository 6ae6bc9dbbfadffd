// The picture as a part wears it.
#pragma once

#include <memory>

#include "engine/image/image.h"
#include "engine/pipeline/part_shape.h"
#include "engine/surface/part_texture.h"

namespace spineloft::pipeline {

/// What `pixels`, on which the part was made, show of it (surface::partTexture), its ends and where
/// rib ends are bridged or guessed taken with doubt. Null when there is nothing to see of it, or no
/// memory.
std::shared_ptr<const surface::PartTexture> textureStage(const PartShape& shape,
                                                         const image::Picture& pixels);

}  // namespace spineloft::pipeline
