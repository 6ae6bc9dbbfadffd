// The surface of a bridge. Internal to bridge/.
#pragma once

#include <vector>

#include "engine/base/vec.h"
#include "engine/bridge/bridge_params.h"
#include "engine/mesh/front_uv.h"
#include "engine/mesh/tri_mesh.h"

namespace spineloft::bridge {

/// A rim as the tube takes it. Rings of both ends have equally many points, counter-clockwise about the way from the
/// first end to the second.
struct TubeEnd {
  std::vector<ModelPoint> ring;
  std::vector<ModelPoint> leave;  ///< unit, one a point: in which direction the tube leaves it
  ModelPoint out;                 ///< unit: in which the tube as a whole does
  double radius = 0;
  ModelPoint centre, lid;  ///< `lid`: the point in the host from which a lid is laid to the ring
};

/// The closed tube. `flare`: 1, or less: its middle is that much less thin than the waist asks for.
mesh::TriMesh tubeBetween(const TubeEnd& from, const TubeEnd& to, const BridgeParams& params, double flare,
                          mesh::PictureSize picture);

}  // namespace spineloft::bridge
