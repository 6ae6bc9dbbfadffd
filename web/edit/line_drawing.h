// Line drawings on the picture in view: where pieces pass over each other, where lines are not closed, and how a line
// under the pen meets those that are there.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/document/document.h"
#include "engine/pipeline/derive.h"
#include "web/ui/ui_state.h"

namespace spineloft::app {

/// A place where two pieces overlap; a tap swaps them there.
struct Crossing {
  PartId over, under;
  PicturePoint at;
  bool guessed = false;  ///< no line says who is in front
};
/// Of all drawings on a picture, in their order; of pieces that are shown.
std::vector<Crossing> crossingsOn(const document::Document& document, const pipeline::Derived& derived,
                                  PictureId picture);
/// "Leg is in front of Body", in the visitor's language.
std::string crossingSentence(const document::Document& document, const Crossing& crossing);

/// What is derived of the drawing of a piece; null without it.
const pipeline::DerivedDrawing* drawingOf(const pipeline::Derived& derived, PartId piece);

/// The turn after which a piece and all of its drawing stand upright in the world. None: for another part, where right
/// angles say nothing (descriptive::Model::up), and where it stands upright.
std::optional<geometry::Turn> turnUpright(const document::Document& document, const pipeline::Derived& derived,
                                          PartId piece);

/// From where right angles can be seen, in words.
struct SeenWords {
  descriptive::SeenFrom from;
  const char* words;
};
inline constexpr std::array kSeenWords = {SeenWords{descriptive::SeenFrom::Above, "From above"},
                                          SeenWords{descriptive::SeenFrom::Below, "From below"},
                                          SeenWords{descriptive::SeenFrom::Unknown, "No right angles"}};
/// From where those of a piece's drawing are seen. None: for another part, and where there are none.
std::optional<descriptive::SeenFrom> seenFrom(const document::Document& document, const pipeline::Derived& derived,
                                              PartId piece);

/// Where a line of no piece ends at nothing.
struct LooseEnd {
  DrawingId drawing;
  LineId line;
  PicturePoint at;
};
/// Of one drawing, of which `drawing` is what is derived.
std::vector<LooseEnd> looseEndsOf(const document::Document& document, const pipeline::DerivedDrawing& drawing);
/// Of all drawings on a picture.
std::vector<LooseEnd> looseEndsOn(const document::Document& document, const pipeline::Derived& derived,
                                  PictureId picture);

/// From a loose end to an end of another line.
struct WayToClose {
  PicturePoint from, to;
  bool hidden = false;  ///< as the line is at its loose end
};
/// The shortest one for the line of `loose`, from its end at `end` where that is stated. None: its own other end is
/// nearer, to which a closed line goes, or there is no other line.
std::optional<WayToClose> wayToClose(const document::Document& document, const pipeline::Derived& derived,
                                     const LooseEnd& loose, std::optional<PicturePoint> end);

/// Both on the canvas as the tool Lines shows them: crossings that would be nearer than a fingertip move apart. Empty
/// while another tool is in hand.
struct LineMarks {
  std::vector<ClientPoint> crossings, looseEnds;
};
LineMarks lineMarks(const document::Document& document, const pipeline::Derived& derived, const UiState& ui);
/// The one within `reach` CSS pixels; −1: none.
int nearestOf(std::span<const ClientPoint> points, ClientPoint at, double reach);

/// A line under the pen as it is meant. `reach`: picture pixels.
struct MeantLine {
  std::vector<PicturePoint> points;  ///< without what a hand adds by trembling
  bool closed = false;
};
/// Ends within reach of each other close a line, unless both lie on lines that are there; any other end within reach of
/// an end of the drawing's lines goes there; else, within reach of a line, it goes onto it, and what runs past it is
/// cut. None of it moves an end by more than a share of the line's own length. What is one more dash begins where it
/// was drawn (descriptive/dashes.h). `drawing` may be null.
MeantLine meantLine(const document::Drawing* drawing, const std::vector<PicturePoint>& line, double reach);
/// The lines of no piece that a new one was drawn over, of the same pen: all of such a line lies within reach of the
/// new one, and it is much longer than that.
std::vector<LineId> drawnOver(const document::Document& document, const document::Drawing& drawing,
                              const document::DrawnLine& fresh, double reach);

}  // namespace spineloft::app
