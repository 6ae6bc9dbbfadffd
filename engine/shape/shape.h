// Shapes: primitives that take the outlines drawn in one, two or three views (ode-character-modelling 4.2 and 5.2.1;
// method-shapes.md).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/result.h"
#include "engine/geometry/region.h"
#include "engine/geometry/view.h"
#include "engine/image/image.h"
#include "engine/mesh/tri_mesh.h"
#include "engine/shape/shape_params.h"

namespace spineloft::shape {

/// An outline as drawn, in pixels of its picture: one closed line, or two open ones.
struct SeenOutline {
  std::optional<geometry::View> view;  ///< of its picture; none: the part's own picture
  const geometry::Contours& lines;
};

struct Shaped {
  mesh::TriMesh mesh;             ///< ModelSpace; UV as seen from the front
  geometry::Contours silhouette;  ///< its outline in the part's picture, one closed line
};

/// The closed solid whose silhouette is the drawn one in every view that has an outline.
///
/// Sections stand along the axis. Each goes through four points: the outline's two sides as seen from the front (or
/// the back) and as seen from the side, or from the top where the axis is level; where nothing is drawn, through those
/// of the primitive and of params.depth. An outline in the view that looks along the axis is the section itself, and,
/// where nothing else says it, its height over width the depth. With an outline in a second view the sections are
/// parallel to the rows (columns) that both pictures share; rows of the second one are stretched to those of the first.
///
/// A line that goes ahead along the axis is known by the place; one that steps back, by its length. Where the four
/// points do not lie in a plane, the section rises to each of them levelly (geometry::aroundFour), so that the surface
/// is seen edge on along every drawn line: the line is the silhouette, to the spacing of sections.
///
/// An end without width is a point; others are finished by params.caps. The mesh obeys mesh/laws.h; with a section of
/// one piece its genus is 0. Errors: ValueOutOfRange, StrokeNotFinite, RegionEmpty, SectionInvalid, ShapeInvalid with
/// what is wrong in words. Cost: levels × sides.
Result<Shaped> makeShape(const ShapeParams& params, std::span<const SeenOutline> outlines, image::Size picture);

/// Its outline as a view shows it (none: from the front), pixels of the view's picture: one closed line. Ends are shown
/// flat. Errors: those of makeShape. Cost: levels.
Result<std::vector<PicturePoint>> outlineSeen(const ShapeParams& params, std::span<const SeenOutline> outlines,
                                              const std::optional<geometry::View>& view);

/// What an outline says of a shape with this axis.
enum class Role : std::uint8_t { Width, Depth, Section };
Role roleOf(const Axis& axis, const std::optional<geometry::View>& view);

}  // namespace spineloft::shape
