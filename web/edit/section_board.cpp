// The board on which a section is drawn.
#include <algorithm>
#include <array>

#include "engine/document/checks.h"
#include "web/edit/layer_board.h"
#include "web/edit/preview.h"
#include "web/edit/section_editing.h"

namespace spineloft::app {
namespace {

constexpr std::size_t kMostSteps = 200;  // that the board can take back
constexpr std::array<std::string_view, static_cast<std::size_t>(BoardTool::kCount)> kToolKeys = {"pen", "line", "box",
                                                                                                 "ellipse", "points"};

using Line = std::vector<SectionPoint>;

/// A gesture or a button ended: what was between is gone.
void forgetGesture(SectionBoard& board) {
  board.live.reset();
  board.stroke.clear();
}

/// One step from `from` to `to`.
bool step(SectionBoard& board, std::vector<sections::Drawing>& from, std::vector<sections::Drawing>& to) {
  if (from.empty()) return false;
  forgetGesture(board);
  board.corners.clear();
  board.point.reset();
  to.push_back(std::move(board.drawing));
  board.drawing = std::move(from.back());
  from.pop_back();
  return true;
}

/// Shows the part as this would make it.
void previewRecipe(UiState& ui, const document::Part& part, document::Recipe recipe) {
  Preview& preview = previewPart(ui, part);
  if (preview.recipe == recipe) return;
  preview.recipe = std::move(recipe);
  preview.fresh = false;
}

}  // namespace

std::string_view boardToolKey(BoardTool tool) {
  return tool < BoardTool::kCount ? kToolKeys[static_cast<std::size_t>(tool)] : std::string_view();
}

std::optional<BoardTool> boardToolFromKey(std::string_view key) {
  const auto at = std::ranges::find(kToolKeys, key);
  if (at == kToolKeys.end()) return std::nullopt;
  return static_cast<BoardTool>(at - kToolKeys.begin());
}

Result<sections::SectionShape> shapeOnBoard(const SectionBoard& board) {
  return board.profile ? sections::profileOf(board.shown()) : sections::sectionOf(board.shown());
}

SectionPoint toSection(const SectionBoard& board, ClientPoint at) {
  const double half = board.square.width / 2 / kBoardReach;
  const ClientPoint c = board.square.centre();
  if (half <= 0) return {};
  return {(at.x - c.x) / half, (c.y - at.y) / half};
}

ClientPoint toCanvas(const SectionBoard& board, SectionPoint p) {
  const double half = board.square.width / 2 / kBoardReach;
  const ClientPoint c = board.square.centre();
  return {c.x + p.x * half, c.y - p.y * half};
}

void openBoard(UiState& ui, const BoardStart& start, const sections::SectionShape& shape) {
  SectionBoard board;
  if (start.part) board.part = start.part->id;
  board.key = start.key;
  board.profile = start.profile;
  board.symmetry.leftRight = start.profile;
  Result<sections::Drawing> drawing = sections::drawingOf(shape);
  if (drawing && start.empty) {
    for (const sections::DrawnCurve& curve : drawing.value()) {
      keepTrace(ui.sections, sections::outlineOf(curve));
    }
  } else if (drawing) {
    board.drawing = std::move(drawing).value();
    board.tool = BoardTool::Points;
  }
  showBoard(ui, std::move(board));
}

void showBoard(UiState& ui, SectionBoard board) {
  board.tool0 = ui.tool;
  board.selected0 = ui.selection;
  ui.sections.board = std::move(board);
  ui.sections.placing = false;
  ui.layers.drawsRail = false;
  closeMenus(ui);
  ui.preview.reset();
}

void closeBoard(UiState& ui) {
  ui.sections.board.reset();
  ui.preview.reset();
}

void changeDrawing(SectionBoard& board, sections::Drawing next) {
  forgetGesture(board);
  if (next == board.drawing) return;
  board.past.push_back(std::move(board.drawing));
  if (board.past.size() > kMostSteps) board.past.erase(board.past.begin());
  board.future.clear();
  board.drawing = std::move(next);
}

bool undoBoard(SectionBoard& board) {
  if (!board.corners.empty()) {
    board.corners.pop_back();
    return true;
  }
  return step(board, board.past, board.future);
}

bool redoBoard(SectionBoard& board) { return step(board, board.future, board.past); }

sections::Drawing withCurves(const sections::Drawing& drawing, const sections::Drawing& curves) {
  std::vector<Line> fresh;
  for (const sections::DrawnCurve& curve : curves) fresh.push_back(sections::outlineOf(curve));
  sections::Drawing out;
  for (const sections::DrawnCurve& curve : drawing) {
    const Line line = sections::outlineOf(curve);
    const bool free =
        std::ranges::none_of(fresh, [&](const Line& other) { return sections::outlinesMeet(line, other); });
    if (free) out.push_back(curve);
  }
  out.insert(out.end(), curves.begin(), curves.end());
  return out;
}

void keepTrace(SectionUi& sections, std::span<const SectionPoint> line) {
  if (line.size() < 3) return;
  sections.traces.emplace_back(line.begin(), line.end());
  if (sections.traces.size() > kMostTraces) sections.traces.erase(sections.traces.begin());
}

void growBoard(UiState& ui, const document::Document& document) {
  constexpr std::size_t kFewest = 3;  // points of a line that may make a curve
  if (!ui.sections.board || ui.sections.board->stroke.size() < kFewest) return;
  SectionBoard& board = *ui.sections.board;
  const bool freehand = board.tool == BoardTool::Pen;
  if (!freehand && board.tool != BoardTool::Box && board.tool != BoardTool::Ellipse) return;
  const Result<sections::Drawing> curves = freehand ? sections::drawFreehand(board.stroke, board.symmetry)
                                                    : sections::drawOutline(board.stroke, board.symmetry);
  if (!curves) return;
  board.live = withCurves(board.drawing, curves.value());
  previewBoard(ui, document);
}

void previewBoard(UiState& ui, const document::Document& document) {
  if (!ui.sections.board) return;
  const SectionBoard& board = *ui.sections.board;
  const document::Part* part = document::findPart(document, board.part);
  if (part == nullptr) return;
  Result<sections::SectionShape> shape = shapeOnBoard(board);
  if (!shape || board.past.empty()) {
    if (!board.live) ui.preview.reset();
    if (!shape || !board.live) return;  // the last valid one stays until the gesture ends
  }
  if (board.sheet) {
    if (const auto sheet = sheetOfBoard(document, ui)) previewRecipe(ui, *part, withBoard(*sheet, board));
    return;
  }
  if (board.profile) {
    document::InflateRecipe puff = *document::inflateOf(*part);
    auto& slices = puff.inflate.profile.slices;
    if (slices.empty()) slices.resize(1);
    slices[std::min(board.key, slices.size() - 1)].shape = std::move(shape).value();
    if (document::checkSolid(puff.inflate)) previewRecipe(ui, *part, std::move(puff));
    return;
  }
  loft::LoftParams params = document::loftIn(*part).loft;
  const std::size_t key = std::min(board.key, params.sections.size() - 1);
  params.sections[key].shape = std::move(shape).value();
  if (!loft::checkSectionKeys(params.sections)) return;
  previewLoft(ui, *part, std::move(params));
}

}  // namespace spineloft::app
