// A line drawing as derived: all its pieces at once, since each has its depth from the others.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/base/result.h"
#include "engine/descriptive/model.h"
#include "engine/document/document.h"
#include "engine/pipeline/part_shape.h"

namespace spineloft::pipeline {

/// An end of a line that belongs to no piece and meets no other line.
struct OpenEnd {
  std::uint32_t line = 0;  ///< its place in the drawing's list
  PicturePoint at;
};

/// A drawing, solved. Without pieces there is no model.
struct DrawingShape {
  descriptive::Model model;
  std::optional<Failure> failure;  ///< of all pieces; then the model is empty
  std::vector<OpenEnd> openEnds;
};

/// Memory that it takes, about.
std::size_t bytesOf(const DrawingShape& shape);

/// Solves it. Errors: those of descriptive::modelOf and OutOfMemory stand in `failure`.
DrawingShape drawingStage(const descriptive::Drawing& drawing);

/// A drawing as engine/descriptive takes it, and one of its pieces.
struct PieceIn {
  descriptive::Drawing drawing;
  std::size_t number = 0;
};
/// The drawing of the recipe with it as the piece that `part` is; without a part as the piece that has its outlines, or
/// else as one more. Without the drawing there are no lines.
PieceIn pieceIn(const document::Document& document, const document::ElementRecipe& recipe, PartId part);

/// Mesh and contours of a piece. Errors: that of the drawing, or why this piece is no solid.
Status elementStage(const DrawingShape& drawing, std::size_t piece, PartShape& shape);

}  // namespace spineloft::pipeline
