// Line drawings as authored: lines on a picture, what is known of their depth, and who is in front of whom. Their
// pieces are parts (ElementRecipe of document.h).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/ids.h"
#include "engine/base/vec.h"
#include "engine/descriptive/drawing.h"

namespace spineloft::document {

/// A line of a drawing, pixels of its picture.
struct DrawnLine {
  LineId id;
  std::vector<PicturePoint> points;          ///< as drawn, ≥ 2
  std::vector<descriptive::Stretch> hidden;  ///< where something is in front of it; growing, apart
  bool closed = false;                       ///< its last point is joined to its first
  bool operator==(const DrawnLine&) const = default;
};

/// A way along a line, shares of its length in 0…1; against its direction where from > to.
struct LineRun {
  LineId line;
  double from = 0, to = 1;
  bool operator==(const LineRun&) const = default;
};
/// A closed outline: each run begins where the one before it ends; gaps are closed
/// (pathOf of descriptive/outlines.h).
struct LineOutline {
  std::vector<LineRun> runs;
  bool operator==(const LineOutline&) const = default;
};

/// The depth of a place on a line is given: z in picture pixels, larger is nearer to the viewer.
struct DepthPin {
  LineId line;
  double at = 0, z = 0;  ///< at: share of the line's length
  bool operator==(const DepthPin&) const = default;
};

/// Where a line may turn off its plane.
struct LineFold {
  LineId line;
  double at = 0;
  bool operator==(const LineFold&) const = default;
};

/// Of two pieces that overlap at a place, who is in front there.
struct PieceOrder {
  PartId over, under;
  PicturePoint at;
  bool operator==(const PieceOrder&) const = default;
};

/// Everything that was drawn as lines on one picture.
struct Drawing {
  DrawingId id;
  PictureId picture;
  std::vector<DrawnLine> lines;  ///< in the order they were drawn
  std::vector<DepthPin> pins;
  std::vector<LineFold> folds;
  std::vector<PieceOrder> orders;                                 ///< of two for one place the later one counts
  descriptive::SeenFrom seenFrom = descriptive::SeenFrom::Above;  ///< what has right angles
  std::uint32_t lastLineId = 0;                                   ///< ids of lines are never reused
  std::string extra;                                              ///< as PictureEntry::extra
  bool operator==(const Drawing&) const = default;
};

inline constexpr std::size_t kMostDrawings = 500, kMostMarks = 2000;  ///< marks: pins, folds or orders of a drawing

}  // namespace spineloft::document
