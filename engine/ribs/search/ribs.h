// Ribs: what one stroke finds in a picture.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/base/vec.h"
#include "engine/image/edge_map.h"
#include "engine/ribs/base/picture_evidence.h"
#include "engine/ribs/base/rib_params.h"
#include "engine/ribs/base/rib_set.h"
#include "engine/ribs/base/spine.h"
#include "engine/ribs/search/workspace.h"

namespace spineloft::ribs {

/// Gradient curves from the hull of the spine, the evidence along them, and the exact optimum of
/// the energy by dynamic programming (method: "Gradient curves", "Rib lengths"). Without
/// edges every end is Guessed at a default width; under ignored ones the picture says nothing. Output coordinates are
/// picture pixels, at most half a pixel outside the picture; ribs of one side never cross each other. Errors:
/// StrokeTooShort (fewer than 2 points), ValueOutOfRange (params), Cancelled.
Result<RibSet> traceRibs(const Spine& spine, const PictureEvidence& picture, const RibParams& params,
                         const Progress& progress);
/// The same with memory that is reused from call to call: for the pen.
Result<RibSet> traceRibs(const Spine& spine, const PictureEvidence& picture, const RibParams& params,
                         const Progress& progress, RibWorkspace& memory);
/// The same with nothing ignored.
inline Result<RibSet> traceRibs(const Spine& spine, const image::EdgeMap& edges, image::Size picture,
                                const RibParams& params, const Progress& progress) {
  return traceRibs(spine, PictureEvidence{edges, picture}, params, progress);
}

}  // namespace spineloft::ribs
