// Prisms of which no right angle is drawn: a tent, a hexagonal bar.
#pragma once

#include <optional>

#include "engine/descriptive/square.h"

namespace spineloft::descriptive {

/// A solid that is a prism by its faces, with its base seen: n corners, from each of which one edge leads to another
/// base. It is read as a cabinet projection: the base is as it is drawn, its edges back are drawn at half their length.
/// A view from afar shows them so where the base is tilted by α, sin α = ½, about what is across them in the picture,
/// and the base is then shorter along them by cos α: its corners move so. `up` is off the face that is lowest. None
/// where it is no such prism, or edges back are more than kOneDirection apart.
std::optional<FacedSolid> prismOf(const Wireframe& wireframe, const DepthScale& scale);

}  // namespace spineloft::descriptive
