// Layers that stand off the rail of their part, anywhere in space.
#pragma once

#include "engine/base/result.h"
#include "web/edit/layers.h"

namespace spineloft::app {

/// From the place of a layer on the rail to where it stands, picture pixels, along the directions of a sheet there that
/// does not lean: to the right of the way along the rail as the viewer sees it, to the viewer, and on along the rail.
struct Offset {
  double side = 0, front = 0, ahead = 0;
  bool operator==(const Offset&) const = default;
};
Offset offsetOf(const Sheet& sheet, const stack::Plane& plane);

/// The layer on the sheet off the rail, where it stands, or on it again, at its share and as it leans. Errors:
/// StackInvalid (no layer, no rail, a closed one, repeated layers).
Result<document::StackRecipe> withFree(const Sheet& sheet, bool free);
/// The layer on the sheet, which is off the rail, elsewhere.
document::StackRecipe withOffset(const Sheet& sheet, const Offset& offset);
/// The same, moved square to itself, picture pixels.
document::StackRecipe withShift(const Sheet& sheet, double ahead);

}  // namespace spineloft::app
