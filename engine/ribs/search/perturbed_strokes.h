// The perturbed strokes of an ensemble. Internal to ribs/.
#pragma once

#include <array>
#include <vector>

#include "engine/ribs/search/ribs.h"

namespace spineloft::ribs {

/// How a stroke is perturbed: `aside` shifts it to its left (if > 0) by a share of the local width, `longer`
/// lengthens both ends (if < 0, shortens them) by a share of the median width.
struct PerturbedStroke {
  double aside = 0, longer = 0;
};

/// In pairs to either side, so that a mirrored picture gets mirrored ribs.
inline constexpr std::array<PerturbedStroke, 6> kPerturbedStrokes{
    {{-0.24, 0}, {-0.12, 0}, {0.12, 0}, {0.24, 0}, {0, -0.3}, {0, 0.2}}};

/// The perturbed stroke through a part of ≥ 4 ribs, which gives the widths. Picture pixels, ≥ 2 points. It may leave
/// the picture and cross itself.
std::vector<PicturePoint> strokeOf(const PerturbedStroke& hand, const RibSet& part);

}  // namespace spineloft::ribs
