// Drawings of edges: which lines are the edges of a solid, and which of its faces they go round.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/result.h"
#include "engine/descriptive/lines.h"

namespace spineloft::descriptive {

/// A solid as its edges are drawn: corners in the picture and the faces between them.
struct Wireframe {
  using Face = std::vector<std::uint32_t>;  ///< corners, counter-clockwise seen from outside (y up)
  std::vector<PicturePoint> corners;
  std::vector<Face> faces;
  std::vector<bool> isFront;  ///< by face: its outside is seen
};

/// The faces of each solid whose edges are drawn: outlines of a piece of kind Solid. Straight stretches of lines
/// between their corners, ends and branches are edges. A connected set of them with three or more at every corner
/// (two where they go on straight) has two layers: the seen edges, and their outer outline with the hidden ones; each
/// bounded face of a layer is a face of the solid. It is one where no edges of a layer cross, every edge is in two
/// faces, corners − edges + faces = 2, and right angles say how deep it is (square.h). Right for convex solids; others
/// where no edge is seen for a part only. `size`: sizeOf.
std::vector<std::vector<Outline>> proposeWireframes(std::span<const MeasuredLine> lines, std::span<const Node> nodes,
                                                    double size);

/// What lines make: a piece of kind Solid of each solid whose edges are drawn, and a round one of every other outline
/// (proposeOutlines), in the order of their first lines.
std::vector<Piece> proposePieces(std::span<const MeasuredLine> lines, std::span<const Node> nodes, double size);

/// Hidden edges that nobody drew: straight hidden lines that make seen edges a prism (a box, a house, a stair), which
/// is a seen face, its base, and the same moved by the way that edges lead away from it. Only lines with which a piece
/// of kind Solid comes about that is none without them. `measured`, `nodes`: meetingLines and nodesOf of `lines`.
std::vector<Line> missingEdges(std::span<const Line> lines, std::span<const MeasuredLine> measured,
                               std::span<const Node> nodes);

/// The solid that these outlines are the faces of: ends of runs within kSameCorner of the size are one corner. Errors:
/// those of pathOf for a run; ShapeInvalid where an edge is not in two faces, one each way, or no face is seen.
Result<Wireframe> wireframeOf(std::span<const MeasuredLine> lines, std::span<const Outline> faces, double size);

/// The outline of what is seen of it: runs between a face that is seen and one that is not. Errors: those of
/// wireframeOf.
Result<Outline> silhouetteOf(std::span<const MeasuredLine> lines, std::span<const Outline> faces, double size);

/// The corners of the one cycle of edges that a face with `isChosen` has and no other such face has the other way;
/// empty where there are several cycles, or none.
std::vector<std::uint32_t> outerCycle(std::span<const Wireframe::Face> faces, const std::vector<bool>& isChosen);

inline constexpr double kSameCorner = 0.03;  ///< shares of the size
inline constexpr std::size_t kMostCorners = 64, kMostFaces = 64;

}  // namespace spineloft::descriptive
