// The ink of a part's own outline, which is no part of its surface.
#pragma once

#include <vector>

#include "engine/document/document.h"
#include "engine/pipeline/part_shape.h"
#include "engine/ribs/base/rib_set.h"

namespace spineloft::pipeline {

/// The stretches of the pen's strokes on paper that run along the outline of the part, as marks that cover: whoever
/// draws the outline of a thing draws where it ends, and the thing is not black there. Strokes, and what of them leads
/// into the part or away from it, stay. None on a photo. Picture pixels; O(points of the strokes × of the outline).
std::vector<ribs::IgnoreMark> outlineInk(const PartShape& shape, const document::PictureEntry& entry);

}  // namespace spineloft::pipeline
