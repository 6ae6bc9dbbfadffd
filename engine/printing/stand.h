// Whether something stands: its foot, and where its weight is.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/mesh/tri_mesh.h"

namespace spineloft::printing {

/// A point of the ground, in the meshes' unit.
struct GroundPoint {
  double x, z;
};

/// The least angle by which something leans before it falls, radians: it touches the ground at `foot`,
/// its centre of mass is `height` above `centre`. Not above 0 when it falls by itself.
double tippingAngleOf(std::vector<GroundPoint> foot, GroundPoint centre, double height);

/// How much of the lowest end of parts (closed meshes, y up, millimetres) has to be cut off flat for the
/// rest to stand: the least of a hundredth, two, three … of the whole height with a lean of kGoodTippingAngle.
/// None when kMostFoot of the height is not enough, or a part would lose most of itself before.
std::optional<double> flatFoot(std::span<const mesh::TriMesh> parts);

inline constexpr double kGoodTippingAngle = 0.0873;  ///< radians (5°): clearly above kLeastTippingAngle
inline constexpr double kMostFoot = 0.3;

}  // namespace spineloft::printing
