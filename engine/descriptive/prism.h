// Prisms of which no right angle is drawn: a tent, a hexagonal bar.
#pragma once

#include <optional>

#include "engine/descriptive/square.h"

namespace spineloft::descriptive {

/// A solid that is a prism by its faces, with its base seen: n corners, from each of which one edge leads to another
/// base. It is read as a cabinet projection: the base is as it is drawn, its edges back are drawn at half their length.
/// A view from afar shows them so where the base is tilted by α, sin α = ½, about what is across them in the picture,
/// and the base is then shorter along them by cos α: its corners move so. `up` is off the face that looks down most.
/// None where it is no such prism, an edge back is more than kOneDirection off their mean, or, where it has to be
/// `level`, no edge of its base is within 6° of the picture's rows: a base that is not as it is drawn.
std::optional<FacedSolid> prismOf(const Wireframe& wireframe, const DepthScale& scale, bool level);

}  // namespace spineloft::descriptive
