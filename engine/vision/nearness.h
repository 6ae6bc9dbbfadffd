// How near the closest edge is.
#pragma once

#include "engine/image/edge_map.h"

namespace spineloft::vision {

/// Fills the nearness in `map.look` from `map.edges`: 1 on an edge, falling linearly with the exact Euclidean
/// distance to 0 at `map.reach` pixels; all 0 where there is no edge.
/// O(pixels · reach), a few operations of SIMD each. Throws std::bad_alloc; detectEdges catches it.
void fillProximity(image::EdgeMap& map);

}  // namespace spineloft::vision
