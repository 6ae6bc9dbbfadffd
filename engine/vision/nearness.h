// How near the closest edge is.
#pragma once

#include "engine/image/edge_map.h"

namespace spineloft::vision {

/// Fills `map.proximity` from `map.edges`: 1 on an edge, falling linearly with the exact Euclidean
/// distance to 0 at `map.reach` pixels; all 0 where there is no edge.
/// Only distances up to the reach are looked for, which costs about 3 ms a megapixel at a reach of
/// 10 pixels and grows with it; beyond kLongestScan OpenCV's distance transform takes over.
/// Throws std::bad_alloc and cv::Exception.
void fillProximity(image::EdgeMap& map);

/// In map pixels.
inline constexpr int kLongestScan = 64;

}  // namespace spineloft::vision
