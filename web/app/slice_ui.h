// What is transient about slices: the open board on which one is drawn, the shelf of own slices,
// and what is picked along the bone. Part of UiState.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/ids.h"
#include "engine/document/action.h"
#include "engine/loft/section_drawing.h"
#include "web/app/space.h"

namespace spineloft::app {

/// What a press on the board does.
enum class BoardTool : std::uint8_t { Pen, Line, Box, Ellipse, Points, kCount };
/// "pen", "line", "box", "ellipse", "points".
std::string_view boardToolKey(BoardTool tool);
std::optional<BoardTool> boardToolFromKey(std::string_view key);

/// The board on which a slice is drawn. The document does not change until it is done.
struct SliceBoard {
  PartId part;           ///< none: the slice of the next part
  std::size_t stop = 0;  ///< which slice of the part
  loft::Drawing drawing;
  std::vector<loft::Drawing> past, future;  ///< of this board alone
  loft::Symmetry symmetry;
  BoardTool tool = BoardTool::Pen;
  bool traces = true;                   ///< pale lines of what was drawn before
  std::optional<loft::PointRef> point;  ///< the one that was touched last

  /// The gesture in hand: what the board would hold, and the line under the pen. None: `drawing`.
  std::optional<loft::Drawing> live;
  std::vector<SectionPoint> stroke;
  std::vector<SectionPoint> corners;  ///< of the straight lines that are not closed yet

  Rect square;  ///< where the board lies on the canvas, with its margin
  const loft::Drawing& shown() const { return live ? *live : drawing; }
};

/// The board shows a little more than the square of sections, so that lines may begin outside.
inline constexpr double kBoardReach = 1.18;
SectionPoint toSection(const SliceBoard& board, ClientPoint at);
ClientPoint toCanvas(const SliceBoard& board, SectionPoint p);

/// A slice that the visitor keeps, on every model.
struct ShelfSlice {
  std::uint32_t id = 0;
  std::string name;
  loft::SectionShape shape;
};
inline constexpr std::size_t kMostShelfSlices = 48, kMostTraces = 8;

/// A graph in a panel that a finger can take hold of.
struct GraphArea {
  enum class Kind : std::uint8_t { Along, Blend } kind = Kind::Along;
  Rect at;                   ///< of the whole graph
  Rect visible;              ///< what of it the panel shows
  double low = 0, high = 1;  ///< values at its foot and top
};

struct SliceUi {
  std::optional<SliceBoard> board;
  std::vector<std::vector<SectionPoint>> traces;  ///< what was drawn before, latest last
  std::vector<ShelfSlice> shelf;
  std::uint32_t lastShelfId = 0;

  PartId part;           ///< whose slice `stop` is
  std::size_t stop = 0;  ///< the slice that tiles change, of several along the bone
  bool placing = false;  ///< a tap on the part puts a slice there
  std::optional<loft::SectionShape> pressed;  ///< the tile under the finger
  std::optional<loft::SectionShape> carried;  ///< a tile that is dragged to a part
  ClientPoint carriedTo;

  bool alongOpen = false;  ///< the panel shows the graphs
  bool revealGraph = false;  ///< the next frame scrolls them into view
  document::AlongKind along = document::AlongKind::Twist;
  std::optional<geometry::AlongCurve> graph;  ///< as it is while a point is dragged
  std::size_t graphPoint = 0;
  std::vector<GraphArea> graphs;  ///< where they are, as of the last frame

  ClientPoint lastTap;  ///< on the board or a graph, to tell double taps
  double lastTapMs = -1e9;

  std::optional<double> marked;  ///< place along the bone that the pointer is at, on either side
};

}  // namespace spineloft::app
