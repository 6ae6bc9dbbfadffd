// What may stand in a document: the checks that `update` and the readers of files share.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/document/action.h"
#include "engine/document/document.h"

namespace spineloft::document {

inline constexpr std::string_view kFallbackDocumentName = "Model";
/// "Part 3"; "Sketch 2", "Picture 1".
std::string fallbackName(const Part& part);
std::string fallbackName(const PictureEntry& entry);
/// "Solid 2".
std::string fallbackName(const Step& step);
std::string fallbackName(const Group& group);

/// Valid UTF-8 of at most kMaxNameBytes, cut between characters; `fallback` replaces emptiness.
std::string tidyName(std::string name, std::string_view fallback);

/// Finite and in range, at most ribs::kMostIgnoreMarks.
bool isValid(std::span<const ribs::IgnoreMark> marks);
bool isValid(const ribs::IgnoreMark& mark);

/// Whether the recipe's stroke makes a spine on its picture. Errors: NoSuchPicture and those of
/// ribs::cleanSpine.
Status checkStroke(const Document& document, const LoftRecipe& recipe);

/// Whether a region lies on its picture. Errors: NoSuchPicture, ValueOutOfRange (too many points, a
/// pen's width out of range), StrokeNotFinite, RegionEmpty, RegionOutside.
Status checkRegion(const Document& document, const Region& region);

/// Whether a stack has something to stand on and curves in range. Errors: NoSuchPicture, ValueOutOfRange, StackInvalid.
Status checkStack(const Document& document, const StackRecipe& recipe);

/// Whether a picture may show that: the other one is there, is not itself, and is no side; numbers in range. Errors:
/// NoSuchPicture, ViewInvalid, ValueOutOfRange.
Status checkView(const Document& document, PictureId picture, const PictureView& view);

/// Whether a shape's numbers are in range and its outlines are drawn in views of its picture. Errors: NoSuchPicture,
/// ValueOutOfRange (with what), ViewInvalid, StrokeNotFinite, RegionEmpty (a line of less than two points),
/// RegionOutside, ShapeInvalid. Whether the outlines make a shape is only known when it is made.
Status checkShape(const Document& document, const ShapeRecipe& recipe);
/// A bridge in range. Whether its parts are there is not looked at. Errors: NoSuchPicture, ValueOutOfRange, with what.
Status checkBridge(const Document& document, const BridgeRecipe& recipe);

/// Whether `picture` shows `front` from the right or the left.
bool showsSide(const Document& document, PictureId picture, PictureId front);
/// Whether the side outline of a loft or a puff, where it has one, is drawn in a picture of its right or left. Errors:
/// as of checkShape.
Status checkSide(const Document& document, const Recipe& recipe);

/// Whether the lines of a drawing are finite, long enough, within the limits of descriptive/drawing.h and at least in
/// part on its picture. Errors: NoSuchPicture, StrokeNotFinite, StrokeTooShort, StrokeOutsidePicture, ValueOutOfRange
/// (with what).
Status checkLines(const Document& document, const Drawing& drawing);
bool isValid(const DrawnLine& line, image::Size picture);
/// Of a pin: picture pixels, finite and in range.
bool isDepth(double z);

/// The lines, and pins, folds and orders: on lines and pieces that are there. Errors: those of checkLines, NoSuchLine.
Status checkDrawing(const Document& document, const Drawing& drawing);

/// Whether the recipe of a piece has outlines of lines of its drawing, and numbers in range. Errors: NoSuchLine,
/// NoSuchPicture, RegionEmpty, ValueOutOfRange.
Status checkElement(const Document& document, const ElementRecipe& recipe);

/// Errors: NoSuchPicture (the one that is laid on the part), those of relief::checkRelief.
Status checkRelief(const Document& document, const relief::Relief& relief);

/// Takes out a relief whose picture is not there, and what that of a recipe takes out; how many.
std::size_t dropUnseen(const Document& document, Part& part);
/// Takes out outlines whose picture is no view of the part's; how many.
std::size_t dropUnseen(const Document& document, Recipe& recipe);

/// What a region is made into. Errors: ValueOutOfRange; SectionInvalid for a slice that is no profile of a puff.
Status checkSolid(const RegionSolid& solid);

/// What was drawn for a part: that of the above for its kind, and its side outline.
Status checkDrawn(const Document& document, const Recipe& recipe);

/// Whether somebody drew anything: a part, a stroke on paper, a scribble over edges. Pictures alone are no work.
bool holdsWork(const Document& document);

}  // namespace spineloft::document
