// Where the object ends beyond the stroke: the outline of a cap (method: caps overshoot at open ends
// and spike at closed ones unless their length has a prior of its own).
#pragma once

#include <cstdint>
#include <vector>

#include "engine/image/edge_map.h"
#include "engine/ribs/curves.h"
#include "engine/ribs/rib_lengths.h"
#include "engine/ribs/ribs.h"

namespace spineloft::ribs {

/// How an end is finished, as far as the picture shows it.
enum class EndShape : std::uint8_t {
  Round,    ///< half an ellipse over the last rib
  Flat,     ///< a rectangle over the last rib
  Pointed,  ///< a triangle over the last rib
};

/// One end of a traced part. References must outlive the call.
struct EndSite {
  const GradientCurves& curves;
  const std::vector<float>& costs;  ///< of every curve and level, as the search weighs them
  bool atStart = false;
  PicturePoint left, right;           ///< ends of the last rib
  int leftLabel = 0, rightLabel = 0;  ///< their labels
  float neighbourWeight = 0.7f;       ///< against jumps of the outline from its shape
  const image::EdgeMap* edges = nullptr;  ///< a drawn outline is met in its middle; may be null
};

/// The shape that explains an end best. Its half width is half the last rib.
struct EndGuess {
  EndShape shape = EndShape::Round;
  double extent = 1;  ///< how far the object goes on beyond the last rib, in half widths, > 0
};

/// Tries every shape at extents between a tenth and four half widths: the sum of the costs where the
/// fan's curves cross its outline, plus a price for what is unusual. Round and one half width
/// where nothing is to be seen. The fan's curves see the middle of a wide end only, for the last ribs bend
/// round it: there the extent is what counts, and the shape may be taken for another.
EndGuess guessEnd(const EndSite& site);

/// The outline: a chain of fan curves between the two ends of the last rib, which follows edges but
/// is held to the guessed shape. A flat one has its two corners as points too.
EndFan followEnd(const EndSite& site, LengthWorkspace& workspace);

}  // namespace spineloft::ribs
