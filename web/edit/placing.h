// Parts in hand in the solid view: which ones, where they are shown, and what a motion makes of them.
// Tools preview and commands act through the same functions.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "engine/document/action.h"
#include "engine/document/document.h"
#include "engine/pipeline/derive.h"
#include "engine/pipeline/world.h"
#include "web/ui/ui_state.h"

namespace spineloft::app {

/// Every selected part with the rest of its group, in the order of the list; none without a selection.
std::vector<PartId> selectedParts(const document::Document& document, const UiState& ui);
bool isSelected(const document::Document& document, const UiState& ui, PartId part);
/// One more part in hand, or no longer: with the last one gone nothing is selected.
void addToSelection(const document::Document& document, UiState& ui, PartId part);
/// The part with the rest of its group.
std::vector<PartId> withGroup(const document::Document& document, PartId part);
/// The parts, and before each bridge what it stands on: that goes along with it.
std::vector<PartId> withHosts(const document::Document& document, std::span<const PartId> parts);

/// Where a part is shown now: where the gesture in hand has it, else where it stands.
document::PlaceParts::One standOf(const UiState& ui, const document::Part& part);
pipeline::Copies shownCopies(const UiState& ui, const document::Part& part, image::Size picture);
/// The same for the shape in ui.preview, whose part may not be there yet.
pipeline::Copies previewCopies(const document::Document& document, const pipeline::Derived& derived, const UiState& ui,
                               image::Size picture);

/// About what the parts turn and grow: the mean of their pivots where they are shown. None without a
/// part that has a shape.
std::optional<WorldPoint> centreOf(const document::Document& document, const pipeline::Derived& derived,
                                   const UiState& ui, std::span<const PartId> parts);

/// The parts after a motion. Planes of live symmetry go along when something moves that has none: an
/// ear moves against its twin, a whole animal takes both along. A bridge takes along what it stands on, which comes
/// before it.
std::vector<document::PlaceParts::One> movedParts(const document::Document& document, const pipeline::Derived& derived,
                                                  std::span<const PartId> parts, const document::Motion& motion);

/// Millimetres that a unit of the world is now; 0 when there is nothing to measure.
double mmPerUnit(const document::Document& document, const pipeline::Derived& derived);

/// As actions: parts keep their size in millimetres, so that the model's height changes with them.
std::vector<document::Action> placeActions(const document::Document& document, const pipeline::Derived& derived,
                                           std::vector<document::PlaceParts::One> parts);

/// A way in which a thing has another side: `normal` points from the one to the other.
struct MirrorAxis {
  const char* key;    ///< "x"
  const char* words;  ///< "Left and right"
  const char* brief;  ///< on a small picture
  const char* icon;   ///< that picture in the shell
  WorldPoint normal;
};
/// All of them, the commonest first.
std::span<const MirrorAxis> mirrorAxes();
/// Whether the plane lies between the sides of this axis.
bool isAcross(const document::MirrorPlane& plane, const MirrorAxis& axis);

/// The way in which these parts most likely have another side. Left and right where everything else is alike there and
/// the parts are not in its middle; front and back where they stand before or behind it, as a wing drawn on a bird
/// that is seen from the side.
const MirrorAxis& likelyAxis(const document::Document& document, const pipeline::Derived& derived,
                             std::span<const PartId> parts);

/// A plane through the middle of everything but `parts` (of themselves: at their right, upper or front
/// side, when there is nothing else).
document::MirrorPlane planeFor(const document::Document& document, const pipeline::Derived& derived,
                               std::span<const PartId> parts, const MirrorAxis& axis);

/// The motion, without a turn, after which the parts touch a surface at `at`: of all their points the
/// lowest along the surface's `normal` (of several the one nearest to their middle) comes to lie there.
/// None without a part that has a shape.
std::optional<document::Motion> settleOn(const document::Document& document, const pipeline::Derived& derived,
                                         std::span<const PartId> parts, WorldPoint at, WorldPoint normal);

/// What is shown and typed of a part's place: "x", "y", "z" in millimetres, "tip", "turn", "lean" in
/// degrees, "size" in percent; `mm` as of mmPerUnit. 0 for another key.
double placeNumber(const document::Part& part, std::string_view key, double mm);

}  // namespace spineloft::app
