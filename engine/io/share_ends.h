// How a share text tells the ends of ribs and the outlines of a part's ends (share_text.h). Internal to io/.
#pragma once

#include <cstddef>

#include "engine/document/document.h"
#include "engine/io/json_fields.h"

namespace spineloft::io {

/// The version from which on ends at ribs are told beside their curves, and the text is the shorter by its zeros.
inline constexpr int kFirstOnCurves = 3;

/// Ends of so many ribs in a text are told beside curves, those of the first parts; others in the frame of the spine.
/// This bounds the time that a text takes, whoever wrote it.
struct TracedRibs {
  std::size_t left = 20000;
};

/// The edits of a recipe whose stroke is as a text keeps it, as a text tells them. A fan of n points is told by 2 n
/// numbers, two of them in place of a point: how much farther out than half the width of its rib the middle point is,
/// then for each other point how far it is out of an ellipse as far out as that (ribs::onEllipse), then for each half
/// of how far it is beside its place there on the way round. Picture pixels, multiples of 2 shareStep, and the halves
/// of shareStep.
void tellEnds(document::LoftRecipe& recipe, image::Size picture, TracedRibs& traced);

/// In the JSON of a document with such recipes the edits come to what a text of this version says.
void findEnds(Json& document, int version);

}  // namespace spineloft::io
