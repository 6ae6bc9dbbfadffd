// The pieces of a line drawing: parts that are solved together.
#pragma once

#include <span>
#include <vector>

#include "engine/document/document.h"

namespace spineloft::document {

/// A drawing with its pieces as engine/descriptive takes it. Lines count by their place in the list.
struct PlainDrawing {
  descriptive::Drawing drawing;
  std::vector<PartId> pieces;  ///< the part that each piece is, oldest first
};
PlainDrawing plainDrawing(const Document& document, const Drawing& drawing);
/// Its lines alone.
std::vector<descriptive::Line> plainLines(const Drawing& drawing);

/// Its pieces, oldest first.
std::vector<const Part*> piecesOf(const Document& document, DrawingId drawing);

/// One recipe as a piece of its drawing; `picture`: the size of the drawing's picture.
descriptive::Piece pieceOf(const Drawing& drawing, const ElementRecipe& recipe, image::Size picture);

/// The line, or null.
const DrawnLine* findLine(const Drawing& drawing, LineId id);
/// The first drawing on a picture, which new lines belong to; null: none yet.
const Drawing* drawingOn(const Document& document, PictureId picture);

/// Whether the run is the whole line: the line belongs to that outline.
bool isWhole(const LineRun& run);
/// Whether the outline has the line whole.
bool owns(const LineOutline& outline, LineId line);
/// Whether the piece has it: whole, or of a solid any stretch of it, which is an edge.
bool owns(const ElementRecipe& recipe, LineId line);
/// All lines that it has.
std::vector<LineId> linesOf(const ElementRecipe& recipe);

/// Lines that no piece has a stretch of, in their order.
std::vector<LineId> freeLines(const Document& document, const Drawing& drawing);

}  // namespace spineloft::document
