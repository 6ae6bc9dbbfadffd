// The sheet on which the tool Layers draws: where it stands, and what becomes of the lines on it. The tool previews and
// commands act through the same functions.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "engine/document/document.h"
#include "engine/pipeline/world.h"
#include "engine/stack/stand.h"
#include "web/ui/ui_state.h"

namespace spineloft::app {

/// A sheet of the part made of layers that is in hand, else of the next part.
struct Sheet {
  PartId part;                       ///< none: the next part
  document::StackRecipe recipe;      ///< of the part; of the next one its rail alone
  double at = 0;                     ///< share of the rail; without a rail the number of a layer
  std::optional<std::size_t> layer;  ///< the one that it lies on
  geometry::Turn turn;               ///< from how it would stand on the rail
  stack::Stand stand, home;          ///< and on the rail, not turned
  double half = 0;                   ///< of its side, picture pixels

  bool onRail() const { return !recipe.rail.points.empty(); }
  /// It lies on a layer that is off the rail.
  bool isFree() const { return layer && recipe.planes[*layer].origin; }
};
/// A sheet at a place of the part, or, without one, of a next part on the picture; without a place at the last layer.
/// `turn` is for a sheet that lies on no layer. None for a part that is not made of layers, and without a picture.
std::optional<Sheet> sheetFor(const document::Document& document, PartId part, PictureId picture,
                              std::optional<double> at, const geometry::Turn& turn = {});
/// The part made of layers that is in hand; null: a sheet is of the next part.
const document::StackRecipe* layersInHand(const document::Document& document, const UiState& ui);
/// The one that is seen: none without the tool, for a part that is hidden, and while a board is open.
std::optional<Sheet> shownSheet(const document::Document& document, const UiState& ui);
/// The same without where it stands and how large it is, which takes longer than all else: for what is asked for in
/// every frame.
std::optional<Sheet> shownPlace(const document::Document& document, const UiState& ui);
/// The same where a gesture in hand has it: it goes with the layer that it lies on.
std::optional<Sheet> sheetInHand(const document::Document& document, const UiState& ui);
/// Takes it to another place; off the layers it leans as it was leaned last.
void placeSheet(UiState& ui, const Sheet& sheet, double at);
/// The farthest place: straight rails of new layers grow with the sheet to kMostGrowth times their length; where layers
/// are repeated, the end of their first run.
double mostAt(const Sheet& sheet);
inline constexpr double kMostGrowth = 2;

/// From the sheet's part to the world as it is shown.
pipeline::ToWorld sheetInWorld(const document::Document& document, const pipeline::Derived& derived, const UiState& ui,
                               const Sheet& sheet);

/// Where a point of the canvas is on the sheet's plane; none beside it in the sky.
std::optional<SectionPoint> onSheet(const Sheet& sheet, const pipeline::ToWorld& toWorld, const UiState& ui,
                                    ClientPoint at);
/// Within its edges.
bool isOnSheet(const Sheet& sheet, SectionPoint p);
/// Its corners, in order.
std::vector<ModelPoint> cornersOf(const Sheet& sheet);
/// The knob beside its edge that takes it along the rail.
ModelPoint knobOf(const Sheet& sheet);

/// How far a sheet of a part with a rail leans, degrees: how far its edges to the viewer and to the right are ahead.
struct Lean {
  double front = 0, side = 0;
  bool operator==(const Lean&) const = default;
};
Lean leanOf(const Sheet& sheet);
/// How far it may lean, either way: a layer off the rail may look anywhere.
double mostLean(const Sheet& sheet, double Lean::* way);
inline constexpr double kMostLean = 80;  ///< on the rail
/// The turn of a layer of the part, as Sheet has it.
geometry::Turn turnOf(const Sheet& sheet, const stack::Plane& plane);
/// The turn of the sheet when it leans so.
geometry::Turn turnFor(const Sheet& sheet, const Lean& lean);
/// Both ways to lean, and the knob beside an edge for each: that to the viewer, and the left one.
inline constexpr std::array kLeans{&Lean::front, &Lean::side};
ModelPoint leanKnobOf(const Sheet& sheet, double Lean::* way);

/// A freehand line on the sheet as curves: closed, or, where its ends are farther apart than half its length, the
/// middle of a wall as wide as the part's others. Errors: those of sections::drawFreehand and drawOpenLine.
Result<std::vector<stack::Curve>> curvesOf(const Sheet& sheet, std::span<const SectionPoint> line);
/// A circle or square as large and where the curves of the nearest layer are, else in the middle.
stack::Curve circleOn(const Sheet& sheet);
stack::Curve squareOn(const Sheet& sheet);
/// How wide its next wall is, picture pixels.
double newWallOf(const Sheet& sheet);
/// The layer whose curves lie pale on the sheet and are copied to it: the one before it, else the one after; none of
/// the sheet's own.
const stack::Plane* traceOf(const Sheet& sheet);

/// The recipe with these curves on the sheet. Curves that they cross give way; others stay: a curve in another is a
/// hole, one beside it a branch. A sheet beyond the end of a straight rail makes that longer. A new layer among
/// repeated ones is repeated with them.
document::StackRecipe withCurves(const Sheet& sheet, std::vector<stack::Curve> curves);
/// The layer on the sheet elsewhere on the rail: between its neighbours, or, the last one, farther out. Nothing without
/// one.
document::StackRecipe withMovedLayer(const Sheet& sheet, double to);
/// The layer on the sheet with this turn.
document::StackRecipe withTurn(const Sheet& sheet, const geometry::Turn& turn);
/// How a new part of layers looks: no picture shows it.
document::Look layerLook(const UiState& ui);

/// Without the layer on the sheet.
document::StackRecipe withoutLayer(const Sheet& sheet);

}  // namespace spineloft::app
