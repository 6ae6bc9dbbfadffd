// Dots along the outlines of a piece of a line drawing, dragged nearer or farther in the solid view: pins of its depth.
#pragma once

#include <vector>

#include "engine/document/document.h"
#include "engine/pipeline/derive.h"
#include "web/ui/ui_state.h"

namespace spineloft::app {

struct DepthDot {
  DrawingId drawing;
  LineId line;
  double at = 0;  ///< share of the line's length
  ModelPoint where;
  ClientPoint seen;     ///< on the canvas
  bool pinned = false;  ///< its depth is given
};

/// Of the selected piece while the tool Lines is in hand: its pins, and free places about kDots to an outline and
/// one at least to a run, of a piece with edges its corners. None where it is seen from the front: there depth has no
/// length.
std::vector<DepthDot> dotsOfPiece(const document::Document& document, const pipeline::Derived& derived,
                                  const UiState& ui);
/// The same, which asks for nothing of the second program (SECOND_OBJECTS of web/CMakeLists.txt) without need.
inline std::vector<DepthDot> depthDots(const document::Document& document, const pipeline::Derived& derived,
                                       const UiState& ui) {
  if (ui.tool != ToolKind::Lines || !ui.selection) return {};
  return dotsOfPiece(document, derived, ui);
}

inline constexpr double kDots = 8;

}  // namespace spineloft::app
