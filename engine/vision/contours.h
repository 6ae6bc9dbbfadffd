// Thin contours from a gradient.
#pragma once

#include "engine/image/edge_map.h"
#include "engine/vision/thresholds.h"

namespace spineloft::vision {

/// Fills `map.edges` from its gradient (Canny 1986), rounded to 1/128 Lab unit: the pixels above
/// the low threshold that are the strongest across their contour, of those the contours
/// (8-connected) with a pixel above the high threshold, without the ones that are too short or too
/// faint to be more than noise (isContour). Gradients of 255 Lab units a pixel and more count as
/// 255. Of two equally strong neighbours the left or upper one is thinned away, but level diagonals
/// vanish, all as in OpenCV's Canny with squared gradients, whose edges these are.
/// Throws std::bad_alloc.
void fillEdges(const Thresholds& thresholds, image::EdgeMap& map);

}  // namespace spineloft::vision
