#include "web/ui/sketching.h"

#include <algorithm>

#include "web/ui/ui_state.h"

namespace spineloft::app {
namespace {

constexpr double kClosedShare = 0.25;  // of a line's length may be missing between its ends
constexpr double kLeastLength = 0.12;  // of the longer side of the paper, for a line that counts

double lengthOf(std::span<const PicturePoint> line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += distance(line[i - 1], line[i]);
  return length;
}

}  // namespace

const document::PictureEntry* shownSketch(const document::Document& document, const UiState& ui) {
  const document::PictureEntry* entry = document::findPicture(document, ui.picture);
  return entry != nullptr && entry->isSketch() ? entry : nullptr;
}

std::size_t& sizeInHand(UiState& ui) {
  return ui.tool == ToolKind::Eraser ? ui.sketching.eraserSize : ui.sketching.penSize;
}

void settleSketching(const document::Document& document, UiState& ui) {
  const bool onPaper = ui.tool == ToolKind::Pen || ui.tool == ToolKind::Eraser;
  if (onPaper && shownSketch(document, ui) == nullptr) {
    ui.tool = ToolKind::Draw;
    ui.sketching.stroke.reset();
  }
  if (ui.tool != ToolKind::Pen && ui.tool != ToolKind::Eraser) ui.sketching.menu = PenMenu::None;
}

bool closesOutline(std::span<const PicturePoint> line) {
  return line.size() > 2 && distance(line.front(), line.back()) < kClosedShare * lengthOf(line);
}

bool looksFinished(const document::PictureEntry& sketch) {
  const double least = kLeastLength * std::max(sketch.size.width, sketch.size.height);
  int lines = 0;
  for (const image::SketchStroke& stroke : sketch.sketch) {
    const double length = lengthOf(stroke.points);
    if (stroke.erase || length < least) continue;
    ++lines;
    if (length > 2 * least && closesOutline(stroke.points)) return true;
  }
  return lines >= 2;
}

}  // namespace spineloft::app
