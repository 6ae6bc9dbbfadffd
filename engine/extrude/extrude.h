// Flat pieces: a region with thickness, its edge sharp, bevelled or rounded.
#pragma once

#include "engine/base/result.h"
#include "engine/extrude/extrude_params.h"
#include "engine/geometry/region.h"
#include "engine/image/image.h"
#include "engine/mesh/tri_mesh.h"

namespace spineloft::extrude {

/// The solid over a region, params.thickness of the picture's longer side thick, its middle at
/// params.depth. The edge is cut by the distance to the outline, so that it meets itself in a ridge where
/// the region is narrow and never crosses itself. Where there is such an edge, the outline is first evened out
/// by at most an eighth of its size (geometry/steady.h). ModelSpace; UV as seen from the front; closed, with a
/// handle for every hole. `contours` as geometry::cleanRegion gives them; `picture` in original pixels.
/// Errors: RegionEmpty, RegionTooFine, ValueOutOfRange.
Result<mesh::TriMesh> extrudeRegion(const geometry::Contours& contours, image::Size picture,
                                    const ExtrudeParams& params);

}  // namespace spineloft::extrude
