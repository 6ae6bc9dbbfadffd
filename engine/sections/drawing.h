// Drawing a section by hand: closed curves through a few points, from freehand strokes and from
// shapes, symmetric where asked; and what becomes of them as a SectionShape. Coordinates are those
// of sections: x across the rib, y towards the viewer, the square [−1, 1]².
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/sections/section.h"

namespace spineloft::sections {

/// A point that a curve passes through.
struct DrawnPoint {
  SectionPoint at;
  bool corner = false;  ///< the curve turns sharply here; between two corners it is straight
  bool operator==(const DrawnPoint&) const = default;
};

/// A closed curve through its points (the last one joins the first): cubic arcs whose tangent at a
/// smooth point is that of the circle through it and its neighbours, so that points on a circle
/// give that circle.
struct DrawnCurve {
  std::vector<DrawnPoint> points;
  bool operator==(const DrawnCurve&) const = default;
};
using Drawing = std::vector<DrawnCurve>;

/// What a drawing repeats itself under: mirrors and turns about the middle. With both mirrors, or
/// with a mirror and turns, all that follow from them as well.
struct Symmetry {
  bool leftRight = false, frontBack = false;
  int fold = 1;  ///< turns by 1/fold of a circle, 1…kMostFold
  bool operator==(const Symmetry&) const = default;
  bool none() const { return !leftRight && !frontBack && fold <= 1; }
};
inline constexpr int kMostFold = 8;

/// Every image of `p`, itself first. Mirror images are exact; of turns only halves and quarters
/// are.
std::vector<SectionPoint> images(SectionPoint p, const Symmetry& symmetry);

/// How far an outline may be from its curve, section units.
inline constexpr double kOutlineTolerance = 0.003;
/// How far a curve may be from the line that was drawn, section units.
inline constexpr double kFitTolerance = 0.012;
/// A curve that holds less area, or is narrower than the second, is too small to be a section.
inline constexpr double kLeastArea = 0.002, kLeastWidth = 0.02;
inline constexpr std::size_t kMostCurvePoints = 96;  ///< that fitting makes

/// The curve as a closed polygon, first point first, last not repeated. Reversed or mirrored points
/// (in x or y) give the reversed or mirrored polygon to the last bit. ≥ 3 points, else empty.
std::vector<SectionPoint> outlineOf(const DrawnCurve& curve);

/// The outline from point `i` of a curve to the next one, both included. i < number of points ≥ 3.
std::vector<SectionPoint> stretchOf(const DrawnCurve& curve, std::size_t i);

/// The same of a curve that ends at its last point; at an end it leaves along the circle through that point and the two
/// nearest, of two points straight. i + 1 < number of points ≥ 2.
std::vector<SectionPoint> openStretchOf(const DrawnCurve& curve, std::size_t i);

/// A freehand line as closed curves: ends that run past each other are cut off where they cross,
/// others are joined; tremor is smoothed, corners stay. With a symmetry the longest stretch between two mirrors (or
/// of one turn) is drawn and the rest are its images, as one curve
/// or as several. Curves may still cross themselves or each other (see problemOf). Errors:
/// SectionInvalid (fewer than 3 distinct points, no area), StrokeNotFinite.
Result<Drawing> drawFreehand(std::span<const SectionPoint> stroke, const Symmetry& symmetry);

/// A closed polygon as curves: the same with corners kept and nothing smoothed. Errors: as above.
Result<Drawing> drawOutline(std::span<const SectionPoint> polygon, const Symmetry& symmetry);

/// Straight lines from corner to corner; the box with these opposite corners; the ellipse in it.
DrawnCurve polygonCurve(std::span<const SectionPoint> corners);
DrawnCurve boxCurve(SectionPoint a, SectionPoint b);
DrawnCurve ellipseCurve(SectionPoint a, SectionPoint b);

/// A shape as a drawing that can be changed by its points. Errors: those of drawOutline,
/// SectionInvalid.
Result<Drawing> drawingOf(const SectionShape& shape);

/// Every curve made symmetric: those that meet a mirror or go round the middle by their longest
/// stretch, others by images of their own (left out where they would cross what is there).
Drawing symmetric(const Drawing& drawing, const Symmetry& symmetry);

struct PointRef {
  std::size_t curve = 0, point = 0;
  bool operator==(const PointRef&) const = default;
};
/// Moves a point and the points that are its images. One on a mirror stays on it.
void movePoint(Drawing& drawing, PointRef ref, SectionPoint to, const Symmetry& symmetry);
/// Makes a point and its images corners, or smooth.
void setCorner(Drawing& drawing, PointRef ref, bool corner, const Symmetry& symmetry);
/// Takes a point and its images away; curves left with fewer than 3 points go as a whole.
void removePoint(Drawing& drawing, PointRef ref, const Symmetry& symmetry);
/// Adds a smooth point at `at` between point `ref` and the next one of its curve, and its images
/// where the same stretch is repeated. Returns where it is now.
PointRef addPoint(Drawing& drawing, PointRef ref, SectionPoint at, const Symmetry& symmetry);

/// Left for right; front for back; a quarter turn (counter-clockwise as x right, y up).
enum class Turn { FlipLeftRight, FlipFrontBack, QuarterTurn };
Drawing turned(const Drawing& drawing, Turn turn);

/// Whether the outlines of two closed polygons meet anywhere.
bool outlinesMeet(std::span<const SectionPoint> a, std::span<const SectionPoint> b);

/// Why a drawing is no section yet, and which curve is at fault.
enum class DrawingFault { Empty, TooSmall, CrossesItself, CurvesCross, TooMany };
struct DrawingProblem {
  DrawingFault fault = DrawingFault::Empty;
  std::size_t curve = 0;
  bool operator==(const DrawingProblem&) const = default;
};
std::optional<DrawingProblem> problemOf(const Drawing& drawing);
/// One sentence for a person: what is wrong and what to do.
std::string_view sentenceOf(DrawingFault fault);

/// The drawing as a section: curves within an odd number of others are holes; scaled evenly so that
/// it touches x = ±1. The line y = 0 stays where it was drawn if the whole then fits between y =
/// ±1, else the drawing is shifted along y, and flattened if it is taller than wide. Error:
/// SectionInvalid with the sentence of its problem.
Result<SectionShape> sectionOf(const Drawing& drawing);
/// The same of closed polygons in any order and direction. Errors: SectionInvalid.
Result<SectionShape> sectionOfOutlines(std::vector<std::vector<SectionPoint>> outlines);
/// The drawing as the slice of a puff, which is not scaled: x = ±1 is the outline, and what lies beyond it is brought
/// to it. Errors: those of sectionOf.
Result<SectionShape> profileOf(const Drawing& drawing);

}  // namespace spineloft::sections
