// The stages of a stroke one by one, and how they grow.
#pragma once

#include "engine/image/edge_map.h"
#include "engine/image/image.h"
#include "tests/bench/report.h"

namespace spineloft::bench {

/// Ribs of 25 … 800 points and of 32 … 512 labels; curves, evidence and pair search of a 100-point
/// spine alone; on the map of a picture of `size` with a tube (scene.h).
void reportRibStages(const image::EdgeMap& edges, image::Size size, Report& report);

/// How little the ribs depend on how a stroke was drawn: mean distance between rib ends as a share of the
/// local width, for strokes of 30 and of 3,000 samples, and for the same stroke backwards.
void reportInvariance(const image::EdgeMap& edges, image::Size size, Report& report);

/// The paper's test of d2: a polyline of 2000 vertices on a grid of 300 × 300 points, exactly and
/// hierarchically, with the largest relative error of the latter.
void reportFieldStages(Report& report);

}  // namespace spineloft::bench
