// Whether a model can be printed: closed, of a size that fits, thick enough, and standing by itself.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "engine/mesh/tri_mesh.h"

namespace spineloft::printing {

/// A common printer and what it builds, millimetres: width, depth, height.
struct Printer {
  std::string_view name;
  std::array<double, 3> volume;
};
/// The smallest first.
std::span<const Printer> printers();

/// Thinner walls break, or do not come out at all: two lines of the usual 0.4 mm nozzle.
inline constexpr double kLeastWall = 0.8;
/// By how much more than that needs a model is made larger, for sizes are whole millimetres.
inline constexpr double kMoreThanNeeded = 1.01;
/// Sides of a wall are parallel up to this, radians (20°).
inline constexpr double kWallSlant = 0.349;
/// So much of the surface may be on thinner walls: what is less is a speck.
inline constexpr double kThinShare = 0.01;
/// The least tipping angle of a model that stands, radians (3°): a floor and a table are never quite level.
inline constexpr double kLeastTippingAngle = 0.0524;
/// What lies this near to the ground is stood on, millimetres: a first layer and a half.
inline constexpr double kFootReach = 0.3;

struct PrintCheck {
  bool closed = false;     ///< every part is finite, closed and outward
  std::size_t pieces = 0;  ///< how many come off the printer (see countPieces)
  /// Width (x), depth (z of the meshes), height (y), millimetres.
  std::array<double, 3> size{};
  double volume = 0;  ///< cubic millimetres; where parts overlap it counts twice
  /// Thickness of the walls below which only kThinShare of the surface are, millimetres. A wall has two sides that
  /// look away from each other within kWallSlant; where they run together in an edge or a tip, as parts that are
  /// stuck together do at their seams, it ends in nothing and is none. Without walls, the thickest place. 0 without
  /// triangles.
  double thinnest = 0;
  std::array<double, 3> thinAt{};  ///< a place that thin, in the meshes' space
  std::size_t thinPart = 0;        ///< and the part that it is on
  /// The least angle by which it can be tipped before it falls over, radians; not above 0 when it falls by
  /// itself.
  double tippingAngle = 0;
  bool stands() const { return tippingAngle >= kLeastTippingAngle; }
  /// What does not stand would on a flat foot (see flatFoot).
  bool footHelps = false;
  bool thick() const { return thinnest >= kLeastWall; }
  /// What is not thick would be when all of it is made larger, and would still fit one of the printers.
  bool enlargingHelps = false;
  /// Index of the first printer that it fits into, turned by 90° about the height where that helps; the
  /// number of printers when it fits into none.
  std::size_t printer = 0;
};

/// Looks at parts in millimetres, y up. Thickness: from points spread evenly over the surface (at most
/// 2,000 in all) a ray goes inwards against the normal; its way to where it comes out of the same part
/// is the thickness there (the shape diameter function of Shapira and others, 2008, with one ray, and without the
/// rays that come out aslant).
/// Standing: all material weighs the same; the centre of mass over the convex hull of what is within
/// kFootReach of the ground. The ground is the lowest point. Cost: 2,000 rays times the triangles of a part.
PrintCheck checkPrint(std::span<const mesh::TriMesh> parts);

}  // namespace spineloft::printing
