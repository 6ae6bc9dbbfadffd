// Where the picture is at a place of a surface, as seen from the front.
#pragma once

#include <algorithm>
#include <array>

namespace spineloft::mesh {

/// Of the picture that colours a part, pixels.
struct PictureSize {
  double width = 0, height = 0;
};

/// UV of a place (x right, y up, picture pixels), within the picture.
inline std::array<float, 2> frontUv(double x, double y, PictureSize picture) {
  const double u = (x + 0.5) / picture.width, v = (0.5 - y) / picture.height;
  return {static_cast<float>(std::clamp(u, 0.0, 1.0)), static_cast<float>(std::clamp(v, 0.0, 1.0))};
}

}  // namespace spineloft::mesh
