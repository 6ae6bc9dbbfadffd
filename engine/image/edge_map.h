// What vision tells the ribs about a picture. Plain values, no OpenCV.
#pragma once

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
  /// Nearness to a Canny edge: 1 on it, falling linearly to 0 at `reach` map pixels (method:
  /// "Where is the boundary?"; SpineLoft 3.3.2, distance penalty).
  std::vector<float> proximity;
  double reach = 0;  ///< in map pixels
  /// Colour gradient in CIE Lab (the channel-wise derivatives' dominant direction), in Lab units per
  /// map pixel, x right and y down.
  std::vector<float> gradientX, gradientY;
  /// Colour: CIE Lab, three floats a pixel (L 0…100), slightly smoothed.
  std::vector<float> lab;
  bool operator==(const EdgeMap&) const = default;

  bool empty() const { return width <= 0 || height <= 0; }
  /// Map coordinates of a picture point (map pixel centres at integers).
  Vec2<struct EdgeMapSpace> toMap(PicturePoint p) const {
    return {(p.x + 0.5) / scaleX - 0.5, (p.y + 0.5) / scaleY - 0.5};
  }
};

}  // namespace spineloft::image
