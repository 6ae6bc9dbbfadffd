// Slices of puffs in few characters of a share text. Internal to io/.
#pragma once

#include "engine/io/json_fields.h"

namespace spineloft::io {

/// The version from which on slices are told in short.
inline constexpr int kFirstShortSlices = 4;

/// In a document's JSON, of puffs: a profile that a ready profile or one preset gives is "shape": its key; so is the
/// shape of a slice. Of curves that are the same on both sides one half is kept: "contours" with "mirror", for each of
/// them 0: as it is; 1 + 2 k + odd: point i of n is the mirror image of point k − i, and n is odd or not; −1 − k: the
/// next curve is its mirror image backwards, from point k on. What comes back is equal.
void shortenSlices(Json& document);
void restoreSlices(Json& document);

}  // namespace spineloft::io
