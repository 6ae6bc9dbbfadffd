// What vision tells the ribs about a picture. Plain values, no OpenCV.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/base/vec.h"

namespace spineloft::image {

/// Evidence for boundaries on a reduced copy of the picture. All planes are row-major with
/// width × height entries. Map pixel (i, j) has its centre at picture point
/// ((i + ½) · scaleX − ½, (j + ½) · scaleY − ½).
struct EdgeMap {
  int width = 0, height = 0;
  double scaleX = 1, scaleY = 1;  ///< picture pixels per map pixel, ≥ 1
  /// 255 on a Canny edge, else 0.
  std::vector<std::uint8_t> edges;
  /// What curves read at every one of their points, so it stands together: colour as CIE Lab (L
  /// 0…100), slightly smoothed, and last the nearness to a Canny edge: 1 on it, falling linearly to 0
  /// at `reach` map pixels (method: "Where is the boundary?"; SpineLoft 3.3.2, distance penalty).
  std::vector<std::array<float, 4>> look;
  double reach = 0;  ///< in map pixels
  /// Colour gradient in CIE Lab (the channel-wise derivatives' dominant direction), in Lab units per
  /// map pixel, x right and y down.
  std::vector<float> gradientX, gradientY;
  bool operator==(const EdgeMap&) const = default;

  float nearness(std::size_t pixel) const { return look[pixel][3]; }
  bool empty() const { return width <= 0 || height <= 0; }
  /// Map coordinates of a picture point (map pixel centres at integers).
  Vec2<struct EdgeMapSpace> toMap(PicturePoint p) const {
    return {(p.x + 0.5) / scaleX - 0.5, (p.y + 0.5) / scaleY - 0.5};
  }
};

}  // namespace spineloft::image
