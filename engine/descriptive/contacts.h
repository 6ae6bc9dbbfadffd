// Where pieces touch, they are joined.
#pragma once

#include "engine/descriptive/depth.h"

namespace spineloft::descriptive {

/// A round piece that is hidden behind a flat one, or behind one with plane faces, ends on its back with the gap of the
/// program, so that nothing holds them together, as a leg under a table that is seen from a low place. Where it comes
/// nearer than kTouching, its rim within kBridged of that back gets a front that reaches into it, by 2 kGap and no
/// farther than half through. Neither the order of the two fronts nor that
/// of the two backs changes.
void joinContacts(const DepthInput& input, Depths& depths);

inline constexpr double kTouching = 0.005, kBridged = 0.03;  ///< shares of the size

}  // namespace spineloft::descriptive
