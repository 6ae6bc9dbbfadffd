// What happens to sections while they are edited: the board, previews, places along a spine.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "engine/document/params.h"
#include "engine/pipeline/derive.h"
#include "web/ui/ui_state.h"

namespace spineloft::app {

// ---- The board --------------------------------------------------------------------------------

/// What the board is opened for.
struct BoardStart {
  const document::Part* part = nullptr;  ///< null: the next part
  std::size_t key = 0;
  bool empty = false;    ///< a new section: the shape is a trace only
  bool profile = false;  ///< the slice of a puff
};
/// Opens it with a shape as its drawing, or as a trace below an empty one.
void openBoard(UiState& ui, const BoardStart& start, const sections::SectionShape& shape);
/// Shows a board that is made.
void showBoard(UiState& ui, SectionBoard board);
void closeBoard(UiState& ui);
/// The drawing becomes `next`, as a step that the board can take back.
void changeDrawing(SectionBoard& board, sections::Drawing next);
bool undoBoard(SectionBoard& board);
bool redoBoard(SectionBoard& board);
/// The board's drawing with these curves added: those that they would cross make room.
sections::Drawing withCurves(const sections::Drawing& drawing, const sections::Drawing& curves);
/// Keeps a line as a trace to start from.
void keepTrace(SectionUi& sections, std::span<const SectionPoint> line);
/// Once a frame: what the line under the pen makes of the drawing, and of the part.
void growBoard(UiState& ui, const document::Document& document);
/// The part with the section on the board as it is now, as preview; none while the drawing is no
/// section.
void previewBoard(UiState& ui, const document::Document& document);

// ---- Several sections along a spine ----------------------------------------------------------------

/// Shows a part as it would be lofted with these numbers, until the preview is reset.
void previewLoft(UiState& ui, const document::Part& part, loft::LoftParams params);

/// The section that tiles change: an index into the part's sections.
std::size_t pickedSectionKey(const UiState& ui, const document::Part& part);
/// The section for new parts, or the picked one of the part.
const sections::SectionShape& pickedShape(const UiState& ui, const document::Part* part);

/// One more section at `at`. A part with a single section keeps that one at both ends, or at the far
/// end when `at` is near an end; a section nearly there is replaced. `added` receives the new one's
/// index.
std::vector<loft::SectionKey> withSectionKey(std::span<const loft::SectionKey> keys, double at,
                                             const sections::SectionShape& shape, std::size_t& added);
/// A section moved to `at`, no nearer to its neighbours than their names allow; order stays.
std::vector<loft::SectionKey> withMovedSectionKey(std::span<const loft::SectionKey> keys, std::size_t index, double at);
/// Without a section. The last one stays.
std::vector<loft::SectionKey> withoutSectionKey(std::span<const loft::SectionKey> keys, std::size_t index);
/// A blend of this kind; a custom one keeps the curve that `before` has, or begins as a straight line.
sections::Blend blendOf(sections::BlendKind kind, const sections::Blend& before);
inline constexpr double kSectionKeyGap = 0.02;  ///< least way between two sections, share of the spine
inline constexpr double kNearEnd = 0.15;        ///< a place this near an end means the end's side

/// What a curve is called and measured in.
struct AlongInfo {
  document::AlongKind kind;
  std::string_view key, label, hint;
  double low, high;  ///< values allowed, in the unit that is shown
  double rest;       ///< the value without points, in that unit
  double unit;       ///< what one shown unit is inside (radians a turn …)
  double shown;      ///< half the span a graph shows at least, around `rest`
};
std::span<const AlongInfo> alongTable();
const AlongInfo& alongInfo(document::AlongKind kind);
const AlongInfo* findAlong(std::string_view key);

/// A shape that one tap gives a curve, in shown units.
struct AlongShape {
  document::AlongKind kind;
  std::string_view key, label;
  std::vector<geometry::AlongPoint> points;
};
std::span<const AlongShape> alongShapes();

// ---- Places along a spine ------------------------------------------------------------------------

/// Where share `at` of the spine is in the picture.
PicturePoint placeOnSpine(const pipeline::PartShape& shape, double at);
struct SpinePlace {
  double at = 0;        ///< share of the spine's length
  double distance = 0;  ///< picture pixels from the point to the spine
};
SpinePlace nearestPlace(const pipeline::PartShape& shape, PicturePoint p);
/// The shape of a part as last derived, or null.
const pipeline::PartShape* shapeOf(const document::Document& document, const pipeline::Derived& derived, PartId part);

}  // namespace spineloft::app
