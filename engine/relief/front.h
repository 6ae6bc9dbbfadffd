// The front of a part, and what a picture shows on it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/vec.h"
#include "engine/image/image.h"
#include "engine/mesh/front_uv.h"
#include "engine/mesh/tri_mesh.h"
#include "engine/relief/grid.h"
#include "engine/relief/relief_params.h"

namespace spineloft::relief {

inline constexpr double kLeastSide = 24;  ///< picture pixels: a part that is smaller has no relief

/// A part as a picture shows it.
struct Surface {
  const mesh::TriMesh& mesh;  ///< ModelSpace, with UV in the picture
  mesh::PictureSize picture;
  double scale = 1;  ///< of the mesh to the picture: that of a pose across its spine
};

/// The front of a part: what its UV shows as seen from the front, so that a part in a pose has the front that it has
/// at rest.
struct Front {
  Grid grid;
  double scale = 1;                         ///< of the surface
  double size = 0;                          ///< picture pixels: the longer side of what is seen
  Cells seen;                               ///< where the picture shows the part
  Values z;                                 ///< cells, towards the viewer, where it is seen
  std::vector<std::uint32_t> firstBack;     ///< of each cell in `backs`, and behind the last one their count
  std::vector<std::array<float, 3>> backs;  ///< ModelSpace: where the surface faces away from the viewer
};

/// None: nothing of it is seen, or less than kLeastSide. Cost: the area of the triangles in cells.
std::optional<Front> frontOf(const Surface& surface);

/// How much a triangle faces the viewer at rest: its area in the picture over that in space; < 0: it faces away.
double facing(const Surface& surface, std::uint32_t triangle);

/// Where a vertex lies in the grid of a front, cells.
PicturePoint cellOf(const Surface& surface, const Grid& grid, std::uint32_t vertex);

/// How thick the part is below a place of its front that lies at (x, y) in cells, ModelSpace: how far the nearest place
/// is that faces away, of those that lie there or in eight ways from there in the picture, up to 27 cells far.
/// Infinite where there is none.
double thicknessAt(const Front& front, double x, double y, ModelPoint place);

/// What of a front the relief is to change: where it is seen, within the region, and where the picture that is laid on
/// it has no transparent pixels; and its colours there, sRGB 0 … 1, the mean over each cell.
struct Shown {
  Cells counts;
  std::vector<std::array<float, 3>> colour;
};
/// `pixels`: of the picture that gives the relief, the part's own or the one laid on it.
Shown shownOn(const Front& front, const Relief& relief, const image::Picture& pixels);

}  // namespace spineloft::relief
