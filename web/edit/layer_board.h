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
/// The recipe with what the board shows as the sheet's layer; without problems of the drawing (sections::problemOf)
/// each curve is valid. A curve that was changed keeps its links and forks; one that was not touched stays to the last
/// bit.
document::StackRecipe withBoard(const Sheet& sheet, const SectionBoard& board);

}  // namespace spineloft::app
