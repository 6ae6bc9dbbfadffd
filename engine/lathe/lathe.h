// Spun parts: a region of the picture turned about an axis in its plane.
#pragma once

#include "engine/base/result.h"
#include "engine/geometry/region.h"
#include "engine/image/image.h"
#include "engine/lathe/lathe_params.h"
#include "engine/mesh/tri_mesh.h"

namespace spineloft::lathe {

/// What is turned, as drawn.
struct Profile {
  const geometry::Contours& lines;  ///< picture pixels, finite
  double ribbon = 0;                ///< > 0: the width of the pen that drew `lines`, which are open
  /// The lines are open and closed by the axis: their ends go straight to it.
  bool open = false;
};

/// A spun part.
struct Spun {
  mesh::TriMesh mesh;             ///< ModelSpace; UV as seen from the front
  geometry::Contours silhouette;  ///< where it lies in the picture's plane: the profile, and its mirror image
};

/// The solid that a profile sweeps when it turns about the axis by params.turn. Distances r from the axis count on the
/// side that makes the larger solid; what lies on the other side is cut off at r = 0. Ends of open lines within
/// 2 % of the profile's size of the axis lie on it. With params.wall an open line is the outside of a wall of that
/// thickness towards the inside, with half-round lips; a wall is at least three cells of the grid of cleanRegion
/// thick, and corners inside are rounded by less than a cell. A closed outline is as cleanRegion makes it, but may
/// leave the picture.
///
/// Closed; every corner off the axis is a ring of params.sides points (a part of a turn has so many faces as are begun
/// of them, and two lids), a corner on the axis one point. So a full turn has a handle for every outline that does not
/// meet the axis, and a part of a turn one for every hole. A ring of n points has the volume of the round one times
/// sin(2π/n)/(2π/n). Errors: ValueOutOfRange (parameters), ProfileOnAxis (no area beside the axis), RegionEmpty,
/// RegionTooFine, WallTooThick (no room inside). Cost: linear in the faces, and the cells of the grid for a wall.
Result<Spun> spinRegion(const Profile& profile, image::Size picture, const LatheParams& params);

/// Most corners of a profile; one with more is simplified by at most 0.1 % of its size, then refused (RegionTooFine).
inline constexpr std::size_t kMostCorners = 1500;

}  // namespace spineloft::lathe
