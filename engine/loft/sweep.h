// From sections standing in space to triangles. Internal to loft/.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/vec.h"
#include "engine/image/image.h"
#include "engine/loft/bands.h"
#include "engine/mesh/tri_mesh.h"

namespace spineloft::loft {

/// One section in place: section point (x, y) stands at centre + across · x + depth · y.
struct Station {
  ModelPoint centre, across, depth;
  /// Towards the centre of the bend here, 1 over its radius: what would reach beyond that centre is
  /// held back, so that a bend tighter than the part is thick does not fold. 0: nothing is.
  ModelPoint bend;
  /// A section that is no plane: its points rise by this times what geometry::aroundFour has in their direction between
  /// the heights at x = 1, y = 1, x = −1, y = −1. 0: it is one.
  ModelPoint rise;
  std::array<double, 4> heights{};
  PicturePoint middle, half;  ///< the same in the picture: x = 0 and x = 1 take their colour there
  std::size_t shape = 0;      ///< which of Sweep::shapes
};

/// The point that closes an end.
struct Tip {
  ModelPoint at;
  PicturePoint paint;
};

/// Stations in order (≥ 1; with a single one at least one tip) and how the two ends are closed: joined
/// to each other (≥ 3 stations), by a tip, by an inner wall, else by a lid. Openings of a single
/// station are lids.
struct Sweep {
  std::vector<std::size_t> sizes;    ///< points of each curve of the section
  std::vector<SectionPoint> shapes;  ///< one after the other: all curves' points, then the hub
  std::vector<Station> stations;
  std::optional<Tip> startTip, endTip;
  bool startOpen = false, endOpen = false, joined = false;

  std::size_t count() const;                                     ///< points of a section
  std::span<const SectionPoint> shape(std::size_t which) const;  ///< count() + 1 points
};

/// A ring of the surface: a station, shrunk towards the section's centre for an inner wall.
struct Ring {
  Station station;
  double scale = 1;
};

/// All rings in the order in which the surface runs through them, from its start to its end; the
/// start and end are closed by tips or lids, or joined to each other.
struct RingPath {
  std::vector<Ring> rings;
  bool joined = false;
};

/// A point of a section, and which point of its rib colours it, −1 … 1.
struct PaintedPoint {
  SectionPoint at;
  double paint = 0;
};

/// What sweepMesh asks for besides its result.
struct SweepMemory {
  RingPath path;
  std::array<RingPlanes, 2> planes;
  std::vector<PaintedPoint> points;  ///< of one ring, for those after it that are alike
};

/// The closed mesh in ModelSpace, with UV, in place of what `mesh` held. False when a lid cannot be filled or a
/// triangle is so small that the law of area (mesh/laws.h) might refuse it (a factor 2 is in hand): then `mesh` is of
/// no use.
bool sweepMesh(Sweep& sweep, image::Size picture, SweepMemory& memory, mesh::TriMesh& mesh);

}  // namespace spineloft::loft
