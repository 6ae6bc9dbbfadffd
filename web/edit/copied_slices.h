// Slices that go from one part to another: from bone to rail, from rail to bone, and between two of a kind.
#pragma once

#include "engine/pipeline/slices.h"
#include "web/edit/layers.h"

namespace spineloft::app {

/// A part along a bone or a rail, whose slices can be copied.
inline bool hasSlices(const document::Part& part) {
  const auto* layers = document::stackOf(part);
  return layers ? !layers->planes.empty() : document::loftOf(part) != nullptr;
}
/// Errors: NotAStack (another part, or one that is not derived yet), those of pipeline::slicesOf.
Result<pipeline::Slices> slicesOf(const document::Document& document, const pipeline::Derived& derived, PartId part);

/// The layers at the same shares of the rail of the recipe, as far apart as there is room on a closed one, in place of
/// its own. Its ends, melt and lumps stay. Error: StackInvalid without a rail.
Result<document::StackRecipe> withSlices(const document::StackRecipe& recipe, const pipeline::Slices& slices);
/// A part of its own, of the picture and the melt that a sheet of the next part has, beside what was copied.
document::StackRecipe newWithSlices(const Sheet& sheet, const pipeline::Slices& slices);

}  // namespace spineloft::app
