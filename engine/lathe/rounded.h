// What a silhouette would be if it were round: an axis and a profile.
#pragma once

#include <vector>

#include "engine/base/result.h"
#include "engine/geometry/region.h"

namespace spineloft::lathe {

struct Rounded {
  PicturePoint axisFrom, axisTo;      ///< picture pixels, over the whole silhouette
  std::vector<PicturePoint> profile;  ///< an open line from one to the other, beside the axis
};

/// The solid of revolution whose silhouette is nearest to closed outlines (even-odd, picture pixels, finite): the axis
/// is fitted by least squares to the middles of the chords square to it, weighted by their lengths, beginning with the
/// long principal direction of the area; the radius is half of what each chord has inside. An axis within 3 degrees of
/// upright or level is so. Error: RegionEmpty.
Result<Rounded> rounded(const geometry::Contours& silhouette);

}  // namespace spineloft::lathe
