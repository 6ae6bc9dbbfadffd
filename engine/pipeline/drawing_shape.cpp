#include "engine/pipeline/drawing_shape.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "engine/document/pieces.h"

namespace spineloft::pipeline {
namespace {

/// Ends that meet nothing, of lines in no piece.
std::vector<OpenEnd> openEnds(const descriptive::Drawing& drawing, const std::vector<descriptive::Node>& nodes) {
  std::vector<bool> used(drawing.lines.size(), false);
  for (const descriptive::Piece& piece : drawing.pieces) {
    for (const descriptive::Outline& outline : piece.outlines) {
      for (const descriptive::Run& run : outline) {
        if (run.line < used.size()) used[run.line] = true;
      }
    }
  }
  std::vector<OpenEnd> ends;
  for (const descriptive::Node& node : nodes) {
    if (node.kind != descriptive::NodeKind::End || node.places.empty() || used[node.places[0].line]) continue;
    ends.push_back({node.places[0].line, node.at});
  }
  return ends;
}

DrawingShape solve(const descriptive::Drawing& drawing) {
  DrawingShape shape;
  if (drawing.pieces.empty()) {
    const auto lines = descriptive::meetingLines(drawing.lines);
    if (!lines) {
      shape.failure = lines.failure();
      return shape;
    }
    shape.openEnds = openEnds(drawing, descriptive::nodesOf(lines.value(), descriptive::sizeOf(drawing.lines)));
    return shape;
  }
  Result<descriptive::Model> model = descriptive::modelOf(drawing);
  if (!model) {
    shape.failure = model.failure();
    return shape;
  }
  shape.model = std::move(model).value();
  shape.openEnds = openEnds(drawing, shape.model.nodes);
  return shape;
}

}  // namespace

std::size_t bytesOf(const DrawingShape& shape) {
  std::size_t bytes = sizeof(shape);
  for (const descriptive::ModelPiece& piece : shape.model.solids) {
    const mesh::TriMesh& mesh = piece.mesh;
    bytes += sizeof(piece) + mesh.positions.size() * sizeof(mesh.positions[0]) +
             mesh.triangles.size() * sizeof(mesh.triangles[0]) + mesh.uv.size() * sizeof(mesh.uv[0]);
    for (const auto& contour : piece.region) bytes += contour.size() * sizeof(contour[0]);
  }
  const descriptive::Overlaps& overlaps = shape.model.orders.overlaps;
  for (std::uint32_t cell = 0; !overlaps.all().empty() && cell < overlaps.cells(); ++cell) {
    bytes += sizeof(std::uint32_t) * (1 + overlaps.in(cell).size());
  }
  return bytes;
}

DrawingShape drawingStage(const descriptive::Drawing& drawing) {
  try {
    return solve(drawing);
  } catch (const std::exception&) {  // the standard library only throws for memory
    DrawingShape failed;
    failed.failure = Failure{Error::OutOfMemory, {}};
    return failed;
  }
}

PieceIn pieceIn(const document::Document& document, const document::ElementRecipe& recipe, PartId part) {
  const document::Drawing* drawing = document::findDrawing(document, recipe.drawing);
  if (drawing == nullptr) return {};
  document::PlainDrawing plain = plainDrawing(document, *drawing);
  std::vector<descriptive::Piece>& pieces = plain.drawing.pieces;
  descriptive::Piece own = pieceOf(*drawing, recipe, plain.drawing.size);
  std::size_t number = 0;
  if (part) {
    number = static_cast<std::size_t>(std::ranges::find(plain.pieces, part) - plain.pieces.begin());
  } else {
    number = static_cast<std::size_t>(std::ranges::find(pieces, own.outlines, &descriptive::Piece::outlines) -
                                      pieces.begin());
  }
  if (number == pieces.size()) pieces.emplace_back();
  pieces[number] = std::move(own);
  return {std::move(plain.drawing), number};
}

Status elementStage(const DrawingShape& drawing, std::size_t piece, PartShape& shape) {
  if (drawing.failure) return *drawing.failure;
  const descriptive::Model& model = drawing.model;
  for (const descriptive::LostPiece& lost : model.lost) {
    if (lost.piece == piece) return lost.failure;
  }
  const auto at = std::ranges::find(model.solids, piece, &descriptive::ModelPiece::piece);
  if (at == model.solids.end()) return Error::RegionEmpty;
  shape = {};
  shape.contours = at->region;
  shape.mesh = at->mesh;
  return Done{};
}

}  // namespace spineloft::pipeline
