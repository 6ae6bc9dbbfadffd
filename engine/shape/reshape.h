// What a hand does to a shape: a line drawn at its outline, its axis moved, a primitive fitted to a thing.
#pragma once

#include <optional>
#include <vector>

#include "engine/base/result.h"
#include "engine/geometry/region.h"
#include "engine/geometry/view.h"
#include "engine/shape/shape_params.h"

namespace spineloft::shape {

/// A drawn line is a whole outline: it comes back to where it began. `outline` as of redrawn.
bool isWhole(const std::vector<PicturePoint>& outline, const std::vector<PicturePoint>& line);

/// The closed outline after a line was drawn at it. A whole one takes its place. Another one takes the place of the
/// stretch between the two points of the outline nearest to its ends; of the two stretches between them the one that it
/// runs along. Ends within 3 % of the outline's size are brought onto it, over a tenth of the line. Few points: within
/// 0.15 % of the size, at least half a pixel. The outline as it is where the line has no length. Both in pixels.
std::vector<PicturePoint> redrawn(const std::vector<PicturePoint>& outline, const std::vector<PicturePoint>& line);

/// The axis from end to end of an outline in the picture of the shape, in the direction that it has.
Axis alongOutline(const Axis& axis, const std::vector<PicturePoint>& outline);

/// Where a point of the shape's picture goes when the shape takes other measures: as far along the axis and across, in
/// shares of length and width.
PicturePoint carried(PicturePoint p, const ShapeParams& from, const ShapeParams& to);
/// The same of a pixel of a view; the coordinate that shows only there stays.
PicturePoint carried(PicturePoint p, const geometry::View& view, const ShapeParams& from, const ShapeParams& to);

/// `params` with axis and width of a thing with this closed outline: the long way of its area, upright or level where
/// it is within 5 degrees of that, upright where the thing is round; it begins at the wider end, else at the foot.
/// Error: RegionEmpty.
Result<ShapeParams> fittedTo(const ShapeParams& params, const std::vector<PicturePoint>& outline);

/// The view that lets a picture show a thing from that side as high as another one does (from the top: as wide):
/// `seen` and `front` are closed outlines of the thing in the two pictures. The middle of its area is in the middle of
/// the depth. None: one of them has no extent.
std::optional<geometry::View> alignedView(geometry::ViewFrom from, const std::vector<PicturePoint>& seen,
                                          const std::vector<PicturePoint>& front);

}  // namespace spineloft::shape
