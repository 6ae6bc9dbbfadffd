// A drawing of lines as solids: lines, outlines, orders, depths, meshes in one go.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/descriptive/depth.h"
#include "engine/mesh/tri_mesh.h"

namespace spineloft::descriptive {

/// One piece as a solid.
struct ModelPiece {
  std::uint32_t piece = 0;       ///< index in Model::pieces
  mesh::TriMesh mesh;            ///< ModelSpace, closed
  geometry::Contours region;     ///< what its outlines enclose in the picture
  std::vector<ModelPoint> rim;   ///< points of its middle surface along its outlines; of kind Solid its corners
  std::optional<ModelPoint> up;  ///< of kind Solid: of length 1, off its base
  double planarity = 0;          ///< how far the outline is from its plane, the most, as a share of the drawing's size
};

/// A piece that is none: what its outline encloses makes no solid.
struct LostPiece {
  std::uint32_t piece = 0;
  Failure failure;
};

struct Model {
  std::vector<Piece> pieces;  ///< those of the drawing, or those proposed
  std::vector<Node> nodes;
  Orders orders;  ///< pieces count as in `solids`
  std::vector<ModelPiece> solids;
  std::vector<LostPiece> lost;
  std::vector<std::uint32_t> openLines;                 ///< lines in no outline
  std::vector<std::vector<PicturePoint>> completed;     ///< ways along outlines that no line draws
  std::vector<std::array<std::uint32_t, 2>> conflicts;  ///< pairs of solids whose order cannot hold in depth
  /// Of length 1: what right angles of flat and round pieces say, off the largest flat one within 20°; none: nothing.
  std::optional<ModelPoint> up;
  DepthStats depth;
  double size = 0;  ///< of the drawing, pixels
};

struct ModelOptions {
  int points = 1200;  ///< about so many on both sides of a round piece; 200 … 16000
};

/// Errors: those of meetingLines; ValueOutOfRange for pieces, pins, folds, orders that name what is not there or are
/// out of range; RegionEmpty where nothing closes; those of solveDepths. A piece alone that fails is in `lost`.
Result<Model> modelOf(const Drawing& drawing, const ModelOptions& options = {});

}  // namespace spineloft::descriptive
