// An inflated region: smooth, without ridges, its rim round.
#pragma once

#include "engine/base/result.h"
#include "engine/geometry/region.h"
#include "engine/image/image.h"
#include "engine/inflate/inflate_params.h"
#include "engine/mesh/tri_mesh.h"

namespace spineloft::inflate {

/// The solid between the region's rim in the picture's plane and h = height · √u to the viewer, away from
/// them, or both, where −Δu = 4 in the region and u = 0 on its rim (a circle becomes a ball). ModelSpace;
/// UV as seen from the front; closed, with a handle for every hole. `contours` as geometry::cleanRegion
/// gives them; `picture` in original pixels. The mesh has about params.points corners, even on the
/// surface. Errors: RegionEmpty, RegionTooFine, ValueOutOfRange.
Result<mesh::TriMesh> inflateRegion(const geometry::Contours& contours, image::Size picture,
                                    const InflateParams& params);

}  // namespace spineloft::inflate
