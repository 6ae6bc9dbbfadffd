#include "engine/pipeline/silhouette.h"

#include <array>

#include "engine/base/vec.h"
#include "engine/surface/raster.h"

namespace spineloft::pipeline {

image::Mask rasteriseSilhouette(const mesh::TriMesh& modelSpace, image::Size picture) {
  image::Mask mask;
  if (picture.width <= 0 || picture.height <= 0) return mask;
  mask.width = picture.width;
  mask.height = picture.height;
  mask.pixels.assign(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height), 0);
  const auto at = [&](std::uint32_t v) {
    const auto& p = modelSpace.positions[v];
    return PicturePoint{p[0], -static_cast<double>(p[1])};
  };
  for (const auto& t : modelSpace.triangles) {
    const std::array<PicturePoint, 3> corners = {at(t[0]), at(t[1]), at(t[2])};
    if (isFinite(corners[0]) && isFinite(corners[1]) && isFinite(corners[2])) {
      surface::coverTriangle(corners, mask);
    }
  }
  return mask;
}

}  // namespace spineloft::pipeline
