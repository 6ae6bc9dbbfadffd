#include "engine/document/pieces.h"

#include <algorithm>
#include <cmath>

namespace spineloft::document {
namespace {

/// A run shorter than the whole line by no more than rounding.
constexpr double kRounding = 1e-6;

/// The place of a line in the list; of one that is not there, behind its end.
std::uint32_t placeOf(const Drawing& drawing, LineId id) {
  return static_cast<std::uint32_t>(std::ranges::find(drawing.lines, id, &DrawnLine::id) - drawing.lines.begin());
}

}  // namespace

const DrawnLine* findLine(const Drawing& drawing, LineId id) {
  const auto at = std::ranges::find(drawing.lines, id, &DrawnLine::id);
  return at == drawing.lines.end() ? nullptr : &*at;
}

const Drawing* drawingOn(const Document& document, PictureId picture) {
  const auto at =
      std::ranges::find_if(document.drawings, [&](const Drawing& drawing) { return drawing.picture == picture; });
  return at == document.drawings.end() ? nullptr : &at->get();
}

bool isWhole(const LineRun& run) { return std::abs(run.to - run.from) >= 1 - kRounding; }

bool owns(const LineOutline& outline, LineId line) {
  return std::ranges::any_of(outline.runs, [&](const LineRun& run) { return run.line == line && isWhole(run); });
}

bool owns(const ElementRecipe& recipe, LineId line) { return std::ranges::binary_search(linesOf(recipe), line); }

std::vector<LineId> linesOf(const ElementRecipe& recipe) {
  std::vector<LineId> lines;
  for (const LineOutline& outline : recipe.outlines) {
    for (const LineRun& run : outline.runs) {
      if (isWhole(run) || recipe.kind == descriptive::PieceKind::Solid) lines.push_back(run.line);
    }
  }
  std::ranges::sort(lines);
  lines.erase(std::ranges::unique(lines).begin(), lines.end());
  return lines;
}

descriptive::Piece pieceOf(const Drawing& drawing, const ElementRecipe& recipe, image::Size picture) {
  const auto& [itsPicture, itsDrawing, kind, outlines, stiffness, front, back, thickness] = recipe;
  descriptive::Piece piece{{}, kind, {}, stiffness, front, back, thickness * std::max(picture.width, picture.height)};
  for (const LineOutline& outline : outlines) {
    descriptive::Outline& runs = piece.outlines.emplace_back();
    for (const LineRun& run : outline.runs) runs.push_back({placeOf(drawing, run.line), run.from, run.to});
  }
  return piece;
}

std::vector<const Part*> piecesOf(const Document& document, DrawingId drawing) {
  std::vector<const Part*> parts;
  for (const Part& part : document.parts) {
    const ElementRecipe* element = elementOf(part);
    if (element != nullptr && element->drawing == drawing) parts.push_back(&part);
  }
  // Not in the order of the list, which says nothing about the drawing.
  std::ranges::sort(parts, {}, &Part::id);
  return parts;
}

std::vector<descriptive::Line> plainLines(const Drawing& drawing) {
  std::vector<descriptive::Line> lines;
  for (const DrawnLine& line : drawing.lines) lines.push_back({line.points, line.hidden, line.closed});
  return lines;
}

PlainDrawing plainDrawing(const Document& document, const Drawing& drawing) {
  PlainDrawing plain;
  if (const PictureEntry* entry = findPicture(document, drawing.picture)) plain.drawing.size = entry->size;
  plain.drawing.lines = plainLines(drawing);
  plain.drawing.seenFrom = drawing.seenFrom;
  for (const Part* part : piecesOf(document, drawing.id)) {
    plain.pieces.push_back(part->id);
    plain.drawing.pieces.push_back(pieceOf(drawing, *elementOf(*part), plain.drawing.size));
  }
  for (const auto& [line, at, z] : drawing.pins) plain.drawing.pins.push_back({{placeOf(drawing, line), at}, z});
  for (const auto& [line, at] : drawing.folds) plain.drawing.folds.push_back({placeOf(drawing, line), at});
  const auto numberOf = [&](PartId id) {
    return static_cast<std::uint32_t>(std::ranges::find(plain.pieces, id) - plain.pieces.begin());
  };
  for (const auto& [over, under, at] : drawing.orders) {
    plain.drawing.orders.push_back({numberOf(over), numberOf(under), at});
  }
  return plain;
}

std::vector<LineId> freeLines(const Document& document, const Drawing& drawing) {
  std::vector<LineId> used;
  for (const Part* part : piecesOf(document, drawing.id)) {
    for (const LineOutline& outline : elementOf(*part)->outlines) {
      for (const LineRun& run : outline.runs) used.push_back(run.line);
    }
  }
  std::ranges::sort(used);
  std::vector<LineId> free;
  for (const DrawnLine& line : drawing.lines) {
    if (!std::ranges::binary_search(used, line.id)) free.push_back(line.id);
  }
  return free;
}

}  // namespace spineloft::document
