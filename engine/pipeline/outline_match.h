// How well the silhouette of a part is the outline that was drawn in a view.
#pragma once

#include <optional>

#include "engine/geometry/region.h"
#include "engine/geometry/view.h"
#include "engine/mesh/tri_mesh.h"

namespace spineloft::pipeline {

struct OutlineMatch {
  double iou = 0;                ///< area in both over area in either, 0…1
  double largest = 0, mean = 0;  ///< distance between the two lines both ways, shares of the outline's longer side
};

/// Compares a mesh in ModelSpace, seen in a view (none: from the front), with an outline in pixels of that view: one
/// closed line, or two open ones, which are joined at their nearer ends. On a grid of 2,048 cells along the outline's
/// longer side, so that distances are known to a fortieth of a per cent. All 0 for an outline without an area.
OutlineMatch matchOutline(const mesh::TriMesh& modelSpace, const std::optional<geometry::View>& view,
                          const geometry::Contours& outline);

/// The mesh as a picture of the view shows it: x and −y are pixels of the view, z is 0. For rasteriseSilhouette.
mesh::TriMesh seenIn(const mesh::TriMesh& modelSpace, const std::optional<geometry::View>& view);

}  // namespace spineloft::pipeline
