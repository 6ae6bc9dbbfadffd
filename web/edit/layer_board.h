// A layer on the board for sections: its closed curves are drawn and changed there by their points.
#pragma once

#include <optional>

#include "web/edit/layers.h"

namespace spineloft::app {

/// Whether the layer on the sheet has curves that end: those are drawn on the sheet alone.
bool hasOpenCurves(const Sheet& sheet);
/// Opens the board for the layer on the sheet, or for a new one as large as the nearest.
void openLayerBoard(UiState& ui, const Sheet& sheet);
/// The sheet that the open board lies on; none for another board, and when the part is gone.
std::optional<Sheet> sheetOfBoard(const document::Document& document, const UiState& ui);
/// What the board of a layer shows, of true size. Without problems (sections::problemOf) each curve is valid.
std::vector<stack::Curve> curvesOnBoard(const SectionBoard& board);
/// The recipe with that as the sheet's layer. A curve that was changed keeps its links and forks; one that was not
/// touched stays to the last bit.
document::StackRecipe withBoard(const Sheet& sheet, const SectionBoard& board);

}  // namespace spineloft::app
