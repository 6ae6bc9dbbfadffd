// Edges of a picture. This folder is the only one that includes OpenCV, and it catches its exceptions.
#pragma once

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/image/edge_map.h"
#include "engine/image/image.h"

namespace spineloft::vision {

/// How edges are sought. The defaults are the ones that the benchmark measures.
struct EdgeParams {
  int longSide = 1024;       ///< of the copy that is searched, in pixels, 16…4096
  double blurSigma = 1.2;    ///< of the Gaussian before Canny, in map pixels, 0…5
  double reachShare = 0.01;  ///< half-width of the proximity ramp as a share of the map's width (SpineLoft
                             ///< 3.3.2: box filter of 1 % of the image width), 0.001…0.1
  bool operator==(const EdgeParams&) const = default;
};

/// Canny with thresholds chosen from the picture's own gradient statistics, the proximity ramp, Lab
/// colour and its gradient. Transparent pixels count as white paper.
/// Cost: about 25 ms for a 1024 × 768 copy, one thread, native or in the browser (npm run bench).
/// Errors: PictureEmpty, PictureTooSmall (< kMinPictureSide), ValueOutOfRange (params), Cancelled,
/// OutOfMemory.
Result<image::EdgeMap> detectEdges(const image::Picture& picture, const EdgeParams& params, const Progress& progress);

}  // namespace spineloft::vision
