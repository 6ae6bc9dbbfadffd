// The strokes that perturbed strokes might have drawn through the same thing. Internal to ribs/.
#pragma once

#include <array>
#include <vector>

#include "engine/ribs/search/ribs.h"

namespace spineloft::ribs {

/// How another hand differs: it draws beside the stroke, to its left if > 0, by a share of the local width, or
/// farther at both ends (if < 0, less far) by a share of the usual width.
struct PerturbedStroke {
  double aside = 0, longer = 0;
};

/// In pairs to either side, so that a mirrored picture gets mirrored ribs.
inline constexpr std::array<PerturbedStroke, 6> kPerturbedStrokes{
    {{-0.24, 0}, {-0.12, 0}, {0.12, 0}, {0.24, 0}, {0, -0.3}, {0, 0.2}}};

/// The stroke of another hand through a part of ≥ 4 ribs, whose width is that of the ribs; picture pixels, ≥ 2
/// points. It may leave the picture and cross itself, as a stroke may.
std::vector<PicturePoint> strokeOf(const PerturbedStroke& hand, const RibSet& part);

}  // namespace spineloft::ribs
