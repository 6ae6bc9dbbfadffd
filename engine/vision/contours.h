// Thin contours from a gradient.
#pragma once

#include "engine/image/edge_map.h"
#include "engine/vision/thresholds.h"

namespace spineloft::vision {

/// Fills `map.edges` from its gradient: OpenCV's Canny (Canny 1986) with squared gradients, rounded
/// to 1/128 Lab unit, and our thresholds; of its contours (8-connected) those that are too short or
/// too faint to be more than noise (isContour) are left out.
/// Throws std::bad_alloc and cv::Exception; detectEdges catches both.
void fillEdges(const Thresholds& thresholds, image::EdgeMap& map);

}  // namespace spineloft::vision
