// What is transient about sections: the open board on which one is drawn, the shelf of own sections,
// and what is picked along the spine. Part of UiState.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/ids.h"
#include "engine/document/action.h"
#include "engine/geometry/turn.h"
#include "engine/pipeline/slices.h"
#include "engine/sections/drawing.h"
#include "web/ui/space.h"

namespace spineloft::app {

enum class ToolKind : std::uint8_t;

/// What a press on the board does.
enum class BoardTool : std::uint8_t { Pen, Line, Box, Ellipse, Points, kCount };
/// "pen", "line", "box", "ellipse", "points".
std::string_view boardToolKey(BoardTool tool);
std::optional<BoardTool> boardToolFromKey(std::string_view key);

/// Where the board lies on the sheet of a part made of layers.
struct BoardOnSheet {
  PictureId picture;     ///< of a new part
  double at = 0;         ///< the sheet's place, as app::Sheet has it
  geometry::Turn turn;   ///< and how it is turned where it lies on no layer
  SectionPoint middle;   ///< of the board, picture pixels on the sheet
  double unit = 1;       ///< one section unit, picture pixels
  bool isLevel = false;  ///< the board's right and front are those of the model
};

/// The board on which a section is drawn. The document does not change until it is done.
struct SectionBoard {
  PartId part;          ///< none: the section of the next part
  std::size_t key = 0;  ///< which section of the part
  ToolKind tool0{};     ///< what was in hand when it was opened: with another tool or part the board is used
  PartId selected0;
  bool profile = false;                          ///< the slice of a puff: mirrored, and not scaled
  std::optional<BoardOnSheet> sheet;             ///< a layer is drawn, of true size
  std::vector<std::vector<SectionPoint>> below;  ///< pale outlines of the layer nearest to it
  sections::Drawing drawing;
  std::vector<sections::Drawing> past, future;  ///< of this board alone
  sections::Symmetry symmetry;
  BoardTool tool = BoardTool::Pen;
  bool traces = true;                       ///< pale lines of what was drawn before
  std::optional<sections::PointRef> point;  ///< the one that was touched last

  /// The gesture in hand: what the board would hold, and the line under the pen. None: `drawing`.
  std::optional<sections::Drawing> live;
  std::vector<SectionPoint> stroke;
  std::vector<SectionPoint> corners;  ///< of the straight lines that are not closed yet

  Rect square;  ///< where the board lies on the canvas, with its margin
  const sections::Drawing& shown() const { return live ? *live : drawing; }
};

/// The board shows a little more than the square of sections, so that lines may begin outside.
inline constexpr double kBoardReach = 1.18;
/// What the board shows as a shape. Errors: those of sections::sectionOf.
Result<sections::SectionShape> shapeOnBoard(const SectionBoard& board);
SectionPoint toSection(const SectionBoard& board, ClientPoint at);
ClientPoint toCanvas(const SectionBoard& board, SectionPoint p);

/// A section that the visitor keeps, on every model.
struct ShelfSection {
  std::uint32_t id = 0;
  std::string name;
  sections::SectionShape shape;
};
inline constexpr std::size_t kMostShelfSections = 48, kMostTraces = 8;

/// A graph in a panel that a finger can take hold of.
struct GraphArea {
  enum class Kind : std::uint8_t { Along, Blend } kind = Kind::Along;
  Rect at;                   ///< of the whole graph
  Rect visible;              ///< what of it the panel shows
  double low = 0, high = 1;  ///< values at its foot and top
};

struct SectionUi {
  std::optional<SectionBoard> board;
  std::vector<std::vector<SectionPoint>> traces;  ///< what was drawn before, latest last
  std::vector<ShelfSection> shelf;
  std::uint32_t lastShelfId = 0;

  PartId part;                                    ///< whose section `key` is
  std::size_t key = 0;                            ///< the section that tiles change, of several along the spine
  bool placing = false;                           ///< a tap on the part puts a section there
  std::optional<sections::SectionShape> pressed;  ///< the tile under the finger
  std::optional<sections::SectionShape> carried;  ///< a tile that is dragged to a part
  ClientPoint carriedTo;

  bool alongOpen = false;    ///< the panel shows the graphs
  bool revealGraph = false;  ///< the next frame scrolls them into view
  document::AlongKind along = document::AlongKind::Twist;
  std::optional<geometry::AlongCurve> graph;  ///< as it is while a point is dragged
  std::size_t graphPoint = 0;
  std::vector<GraphArea> graphs;  ///< where they are, as of the last frame

  std::optional<pipeline::Slices> copied;  ///< of a part, for another one

  ClientPoint lastTap;  ///< on the board or a graph, to tell double taps
  double lastTapMs = -1e9;

  std::optional<double> marked;  ///< place along the spine that the pointer is at, on either side
};

}  // namespace spineloft::app
