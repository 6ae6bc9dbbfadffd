// The shape in hand of the tool Shapes, as the picture in view shows it: what a hand can hold of it, and what a gesture
// makes of it. Tools preview and commands do the same.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/document/document.h"
#include "engine/pipeline/part_shape.h"
#include "engine/pipeline/shape_outline.h"
#include "engine/shape/ready_shapes.h"
#include "engine/shape/shape.h"
#include "web/ui/ui_state.h"

namespace spineloft::app {

/// A shape in a picture that is its own or shows a side of it. `part` stays alive while the document does.
struct SeenShape {
  const document::Part* part = nullptr;
  document::ShapeRecipe recipe;        ///< the part's, or what the gesture in hand would make of it
  PictureId picture;                   ///< in which it is seen
  std::optional<geometry::View> view;  ///< of that; none: its own
  std::vector<PicturePoint> outline;   ///< there, one closed line
  shape::Role role() const { return shape::roleOf(recipe.shape.axis, view); }
};
/// None for a part that there is not, that is no shape, that is not seen there, or of which no shape can be made.
std::optional<SeenShape> seenShape(const document::Document& document, PartId part, PictureId picture);
/// The selected one, while the tool is in hand, in the picture in view.
std::optional<SeenShape> shapeInHand(const document::Document& document, const UiState& ui);
/// The same as the gesture in hand would make it.
std::optional<SeenShape> shapeShown(const document::Document& document, const UiState& ui);
/// The selected shape, loft or puff, while the tool is in hand: it can have outlines in other pictures than its own;
/// else null.
const document::Part* partOfViews(const document::Document& document, const UiState& ui);
/// The same, where its own picture is another one than that in view; else null.
const document::Part* shapeElsewhere(const document::Document& document, const UiState& ui);

/// Whether a picture shows a loft or a puff from the right or the left, so that a line in it can be its side outline.
bool isSeenAside(const document::Document& document, const document::Part& part, PictureId picture);
/// The selected one, while the tool is in hand, in the picture in view; else null.
const document::Part* partAside(const document::Document& document, const UiState& ui);
/// The side outline that it gets from lines in such a picture: one closed line, or two open ones.
struct DrawnSide {
  document::Outline side;
  std::optional<geometry::View> view;  ///< as of DrawnShape
};
/// `shape`: as the part is derived.
DrawnSide withSide(const document::Document& document, const document::Part& part, const pipeline::PartShape& shape,
                   document::Outline drawn);

enum class ShapeHold : std::uint8_t {
  From,  ///< the end of the axis where it begins
  To,
  Middle,  ///< moves all of it
  Width,
  Depth,  ///< in a side picture
};
std::string_view holdKey(ShapeHold hold);  ///< "from", "to", "middle", "width", "depth"

struct ShapeHandle {
  ShapeHold hold = ShapeHold::From;
  PicturePoint at;     ///< pixels of the picture in which it is seen
  PicturePoint out{};  ///< the way in which it is held off the outline, of length 1; of the middle 0
};
/// In its own picture both ends, the middle and the width; in a side picture the depth.
std::vector<ShapeHandle> shapeHandles(const SeenShape& seen);
/// Where it is held: off the outline, so that a line may begin there. `zoom`: CSS pixels a picture pixel.
PicturePoint heldAt(const ShapeHandle& handle, double zoom);
/// The one that is held within `reach` CSS pixels of a point of the picture; −1 elsewhere.
int shapeHandleAt(const std::vector<ShapeHandle>& handles, PicturePoint p, double zoom, double reach);
/// What it is and what keys do with it, in the visitor's language.
std::string shapeSentence(ShapeHold hold);

/// The shape with a handle at another place; drawn outlines go along. None: it cannot be there.
std::optional<document::ShapeRecipe> draggedShape(const document::Document& document, const SeenShape& seen,
                                                  const ShapeHandle& handle, PicturePoint to);

/// What a line drawn at the shape's outline makes of it.
struct DrawnShape {
  document::ShapeRecipe recipe;
  /// Of the picture in which it was drawn, where that changes: the first whole outline in a side picture that nobody
  /// has aligned lets both pictures show the thing as high as each other.
  std::optional<geometry::View> view;
};
/// The outline takes the place of others that say the same. In the shape's own picture the axis keeps its direction and
/// goes from end to end.
DrawnShape withLine(const document::Document& document, const SeenShape& seen, const std::vector<PicturePoint>& line);
/// The same as a recipe that makes the shape while the picture still has the view that it had.
document::ShapeRecipe previewOfLine(const document::Document& document, const SeenShape& seen,
                                    const std::vector<PicturePoint>& line);
/// Whether a line that begins there draws at the outline: near it, or anywhere in a side picture. `reach`: picture
/// pixels.
bool drawsOutline(const SeenShape& seen, PicturePoint from, double reach);

/// The next shape with an axis from one place to another, upright or level where it is nearly; as wide as is usual.
document::ShapeRecipe nextShape(const UiState& ui, PicturePoint from, PicturePoint to);
/// The same fitted to a thing: axis and width, and its outline where that makes a shape. Error: RegionEmpty.
Result<document::ShapeRecipe> fittedShape(const document::Document& document, const document::ShapeRecipe& recipe,
                                          const std::vector<PicturePoint>& outline);

/// From where a picture can look, as it is said.
struct SideName {
  geometry::ViewFrom from;
  std::string_view label, tip;
};
std::span<const SideName> sideNames();

/// What `from` says without numbers: both pictures show the same rows (from the top: columns), and the depth is 0 in
/// the middle.
geometry::View plainView(geometry::ViewFrom from, image::Size front, image::Size side);

}  // namespace spineloft::app
