// Many pictures as one, for files that should have a single texture.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/image/image.h"
#include "engine/surface/part_texture.h"

namespace spineloft::surface {

/// Most pixels on a side of an atlas: what every renderer takes.
inline constexpr int kAtlasSide = 4096;
/// Pixels around each picture that repeat its own edge. A filter between four pixels of the second mip
/// level, each a mean of 4 × 4, reaches 6 pixels far and so mixes nothing else in.
inline constexpr int kAtlasPadding = 8;
static_assert(kTextureSide + 2 * kAtlasPadding <= kAtlasSide, "a part's texture fits as it is");
/// The sides are multiples of this, if the most allowed is one: then mip levels halve evenly.
inline constexpr int kAtlasStep = 4;

struct Atlas {
  image::Image pixels;
  /// Where each picture lies, in the order given: UV of the atlas, 0…1, v down.
  std::vector<UvArea> places;
};

/// The pictures side by side on shelves, at most `mostSide` pixels a side; all shrunk alike where
/// they do not fit. A picture that is given several times (the same pointer) lies there once. None
/// without pictures, with an empty one among them, or when not even single pixels fit. Linear but for the
/// sorting, times the few sizes that are tried.
std::optional<Atlas> packAtlas(std::span<const image::Image* const> pictures, int mostSide = kAtlasSide);

/// The UV of a picture of the atlas as UV of the whole atlas.
inline std::array<float, 2> inAtlas(const UvArea& place, double u, double v) {
  return {static_cast<float>(place.left + u * (place.right - place.left)),
          static_cast<float>(place.top + v * (place.bottom - place.top))};
}

}  // namespace spineloft::surface
