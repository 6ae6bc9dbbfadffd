// An inflated region: smooth, without ridges, its rim round.
#pragma once

#include "engine/base/result.h"
#include "engine/geometry/region.h"
#include "engine/image/image.h"
#include "engine/inflate/inflate_params.h"
#include "engine/mesh/tri_mesh.h"

namespace spineloft::inflate {

struct Interior;

/// The solid between the region's rim in the picture's plane and h = height · √u to the viewer, away from
/// them, or both, where −Δu = 4 in the region and u = 0 on its rim (a circle becomes a ball). ModelSpace;
/// UV as seen from the front; closed, with a handle for every hole. `contours` as geometry::cleanRegion
/// gives them; `picture` in original pixels. The mesh has about params.points corners, even on the
/// surface.
///
/// With a profile it is {(p, z) : (s(p), z / H'(p)) in its slice}, s the share of the way from the skeleton of the
/// region to its outline, H' the half width or the largest one (fields.h, rows.h; Levet and Granier 2007): a disc and a
/// circle make a ball, a ring and a circle a torus. `params.height` multiplies z; sides cut the slice at z = 0. A
/// profile that crosses its axis m times and has c curves beside it makes of a piece with h holes m + c (h + 1) shells
/// of genus m h + c (h + 1) in all. Across a length the slice stands over the last `reach` before the outline, where
/// the region is so wide, and what is within is flat. Thin rings are made thicker (thin_rings.h). Errors: RegionEmpty,
/// RegionTooFine, ValueOutOfRange, those of matchedCurves and addRows.
Result<mesh::TriMesh> inflateRegion(const geometry::Contours& contours, image::Size picture,
                                    const InflateParams& params);

/// The same with a profile, over an interior that is known: interiorOf the region for these edits and places of slices.
/// What the slices look like, their width across, the height and the sides may change meanwhile.
Result<mesh::TriMesh> inflateAlong(const Interior& interior, image::Size picture, const InflateParams& params);

}  // namespace spineloft::inflate
