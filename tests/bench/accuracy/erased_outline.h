// A case with a share of its outline gone: what the same picture is worth without it.
#pragma once

#include "engine/base/result.h"
#include "engine/cli/score.h"
#include "engine/image/image.h"

namespace spineloft::accuracy {

/// Fades `share` (0…1) of the true side boundary into what a blur makes of the picture there: in runs
/// as long as the mean local width, `share` of each run, the right side's half a run later than the left's, and
/// within 0.15 of that width (at least 3 px) on either side of the boundary. Nothing of an edge is left, only a
/// soft halo. With `paper` it fades to the picture's most frequent colour instead: a drawn outline is
/// gone altogether. 0 changes nothing. Errors: those of vision::blurred.
Status eraseOutline(const cli::Truth& truth, double share, bool paper, image::Image& image);

}  // namespace spineloft::accuracy
