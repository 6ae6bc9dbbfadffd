// The end of the object beyond the stroke: the outline of a cap (method: "Caps").
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/ribs/base/rib_set.h"
#include "engine/ribs/field/curves.h"
#include "engine/ribs/labels/rib_lengths.h"

namespace spineloft::ribs {

/// How an end is finished, as far as the picture shows it.
enum class EndShape : std::uint8_t {
  Round,    ///< half an ellipse over the ribs at which it begins
  Blunt,    ///< half a superellipse of exponent 4: sides that go on before they bend
  Flat,     ///< a rectangle over them
  Pointed,  ///< a triangle over them
};

/// One end of a traced part: it begins at a rib of either side, and everything outwards of these belongs
/// to it. References must outlive the call.
struct EndSite {
  const GradientCurves& curves;
  const std::vector<float>& costs;  ///< of every curve and level, from the evidence
  bool atStart = false;
  /// How many of the outermost ribs of a side belong to the end; ≥ 0, less than the ribs there are.
  int freeLeft = 0, freeRight = 0;
  PicturePoint left, right;           ///< ends of the ribs at which it begins
  int leftLabel = 0, rightLabel = 0;  ///< their labels
  double halfWidth = 1;               ///< of the part where it ends, picture pixels, > 0: what extents are measured in
  float neighbourWeight = 0.7f;       ///< against jumps of the outline from its shape
};

/// The shape that explains an end best.
struct EndGuess {
  EndShape shape = EndShape::Round;
  double extent = 1;  ///< how far the object goes on beyond the stroke, in half widths, > 0
};

/// Tries every shape at extents between a tenth and four half widths: the sum of the costs where the
/// end's curves cross its outline, plus a price for what is unusual. Round and one half width
/// where nothing is to be seen. The fan's curves see the middle of a wide end only, for the last ribs bend
/// round it: there the extent is what counts, and the shape may be taken for another.
EndGuess guessEnd(const EndSite& site);

/// The outline of an end, from the left rib at which it begins round to the right one.
struct EndOutline {
  EndGuess guess;
  /// Of the free left ribs outwards, the fan's curves and the free right ribs inwards.
  std::vector<int> labels;
  std::vector<PicturePoint> points;
  double cost = 0;  ///< the evidence at these labels and the price of the shape
};

/// The chain of least cost, which follows edges but is held to the guessed shape; in place of what
/// `outline` held, reusing memory.
void followEnd(const EndSite& site, LengthWorkspace& workspace, EndOutline& outline);

/// The fan's share of an outline, in place of what `fan` held. A flat one has its two corners as points too.
void fanOf(const EndSite& site, const EndOutline& outline, EndFan& fan);

}  // namespace spineloft::ribs
