// A profile along the outlines of a region: rows of points on lines of equal s, joined by triangles.
#pragma once

#include <span>

#include "engine/base/result.h"
#include "engine/image/image.h"
#include "engine/inflate/fields.h"
#include "engine/inflate/profile.h"
#include "engine/mesh/tri_mesh.h"

namespace spineloft::inflate {

/// How a profile stands over the fields of a piece.
struct RowParams {
  double spacing = 1;   ///< of the points on the surface, pixels
  double fineness = 1;  ///< of what is thin, see finenessFor
  double height = 1;    ///< z is multiplied by it
  double follow = 1;    ///< see ProfileParams
  double widest = 1;    ///< the largest half width of the region, pixels
  image::Size picture;  ///< of the UV
};

/// H' = H^follow · widest^(1 − follow), by which z of a slice grows where its width is H.
double thicknessOf(double width, const RowParams& params);

/// Adds the surface {(p, z) : (s(p), z / H'(p)) on a curve} of one piece to `mesh` (ModelSpace, UV as seen from the
/// front), H' = thicknessOf times the factor there, and the curve that of the slices by their shares
/// there. Every curve of the profile is a closed surface, or one an outline: see topologyOf. A row at s = 1 is the
/// outline, sampled by the spacing; one at s = 0 the skeleton, to which the plane is triangulated. Error:
/// SectionInvalid, where the surface would go through itself however fine the rows are.
Status addRows(const Fields& fields, const geometry::Contours& piece, const MatchedCurves& curves,
               const RowParams& params, mesh::TriMesh& mesh);

}  // namespace spineloft::inflate
