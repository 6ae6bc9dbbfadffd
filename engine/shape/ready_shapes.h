// The primitives as they are offered: what each is called, and how wide it is where nobody says it.
#pragma once

#include <span>
#include <string_view>

#include "engine/shape/shape_params.h"

namespace spineloft::shape {

struct ReadyShape {
  Primitive primitive;
  std::string_view label;  ///< on the page
  double width;            ///< share of the length of its axis
};
std::span<const ReadyShape> readyShapes();
/// Its row.
const ReadyShape& readyShape(Primitive primitive);

}  // namespace spineloft::shape
