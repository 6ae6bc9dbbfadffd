// The outline of a shape as a picture shows it.
#pragma once

#include <vector>

#include "engine/document/document.h"

namespace spineloft::pipeline {

/// In the shape's own picture, or in one that is a side of that: one closed line, pixels of it. Errors: those of
/// outlineStage, but for a mesh. Cost: far less than the shape.
Result<std::vector<PicturePoint>> outlineIn(const document::ShapeRecipe& recipe, const document::Document& document,
                                            PictureId picture);

}  // namespace spineloft::pipeline
