// The order of the list is an order in depth, the front at its top: what a part that changes its place in the list
// moves to and fro for that.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "engine/document/document.h"
#include "engine/pipeline/derive.h"
#include "web/edit/front_field.h"

namespace spineloft::app {

struct DepthMove {
  double by = 0;       ///< along z of WorldSpace, > 0 nearer to the one who looks at the picture
  std::string beyond;  ///< the part or solid that it stands before or behind then
};

/// The least move along z (WorldSpace, by the meshes of `derived`) that puts `parts` in front of all that they have
/// passed upwards in the list, from `before` to `after`, or behind all that they have passed downwards. Only places
/// count where both are seen from the front. The moved parts end a few percent of the thinner one's depth inside the
/// part that they reach, so that a union makes one piece. None where nothing that was passed overlaps them, where the
/// order is right already, for hidden parts, and for single parts of a solid, which moves as a whole.
std::optional<DepthMove> depthMove(const document::Document& before, const document::Document& after,
                                   const pipeline::Derived& derived, std::span<const PartId> parts);

/// How a thing lies with those that it overlaps in the picture.
struct Lying {
  double hidden = 0;             ///< share of it that they hide, as seen from the front, 0…1
  std::optional<double> front;   ///< along z, after which it lies on all of them, touching them as of depthMove
  std::optional<double> behind;  ///< the same behind them; both none where it overlaps nothing
};
/// Of a thing with this body; `without`: the part that it is already.
Lying lyingOf(const document::Document& document, const pipeline::Derived& derived, const Body& own, PartId without);

}  // namespace spineloft::app
