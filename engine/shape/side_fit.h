// The depth of a part that was made from the front, by its outline from the side (method-shapes.md, "The side of lofts
// and puffs").
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/vec.h"
#include "engine/mesh/tri_mesh.h"
#include "engine/shape/shape.h"

namespace spineloft::shape {

/// What of a part the outline moves: both its sides, or the one before or behind the plane z = 0, which stays.
enum class FitSides : std::uint8_t { Both, Front, Back };

/// What is fitted to an outline.
struct SideTask {
  const mesh::TriMesh& mesh;  ///< ModelSpace
  const SeenOutline& side;    ///< in a view from the right or the left
  FitSides sides = FitSides::Both;
  /// The line that the part goes along, ModelSpace; rows that it crosses more than once keep their depth. None: every
  /// row is decided by the outline.
  std::span<const ModelPoint> spine = {};
};

/// How depth changes: z of a row becomes stretch · z + shift. Between rows both are interpolated; they are constant
/// beyond.
class SideFit {
 public:
  SideFit(std::vector<double> rows, std::vector<double> stretch, std::vector<double> shift);
  /// The depth of a point of the part, ModelSpace. x and y stay.
  double depthOf(double y, double z) const;
  void apply(mesh::TriMesh& mesh) const;

 private:
  std::vector<double> rows_, stretch_, shift_;  ///< rows: y of ModelSpace, increasing
};

/// The change of depth after which the silhouette of the mesh, seen in the view of the outline, is the outline; seen
/// from the front nothing changes. With f and b the farthest depths of the mesh in a row, F and B those of the outline
/// there,
///   z' = (F + B)/2 + (z − (f + b)/2) · (F − B)/(f − b)
/// at both sides, z' = z · F/f in front only, z' = z · B/b behind only. A soft puff, z = ± h √u, thereby becomes
/// (F + B)/2 ± (F − B)/2 · √(u/U), U the largest u of the row. The factor is at most 4 times its median; F − B is at
/// least 4e-4 of the part's size. Rows of the outline are stretched to those of the mesh. Near rows that keep their
/// depth the change fades in over 5 % of the height.
///
/// Errors: ViewInvalid (not from the right or the left), StrokeNotFinite, RegionEmpty, ShapeInvalid with what is wrong
/// in words: it crosses itself or turns back (sideLinesOf), it is of another height (by more than a quarter), it lies
/// beside the plane of a one-sided part, or the spine crosses every row more than once. Cost: edges of the mesh × rows
/// that they span.
Result<SideFit> fitToSide(const SideTask& task);

}  // namespace spineloft::shape
