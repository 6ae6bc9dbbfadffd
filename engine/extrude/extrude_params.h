// What a person chooses about a flat piece: a region with thickness.
#pragma once

#include <cstdint>

namespace spineloft::extrude {

enum class EdgeKind : std::uint8_t { Sharp, Bevel, Round, kCount };

struct ExtrudeParams {
  double thickness = 0.04;  ///< share of the picture's longer side; kLeastThickness … kMostThickness
  EdgeKind edge = EdgeKind::Round;
  double edgeSize = 0.5;  ///< of a bevel or rounding, share of half the thickness, 0 … 1
  double depth = 0;       ///< of its middle towards the viewer, share of the picture's longer side
  bool operator==(const ExtrudeParams&) const = default;
};

inline constexpr double kLeastThickness = 0.002, kMostThickness = 1, kMostDepth = 1;

/// Everything in range and finite.
inline bool isValid(const ExtrudeParams& p) {
  return p.thickness >= kLeastThickness && p.thickness <= kMostThickness && p.edge < EdgeKind::kCount &&
         p.edgeSize >= 0 && p.edgeSize <= 1 && p.depth >= -kMostDepth && p.depth <= kMostDepth;
}

}  // namespace spineloft::extrude
