// What vision tells the ribs about a picture. Plain values, no OpenCV.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/base/vec.h"

namespace spineloft::image {

/// What curves read at every one of their points, so it stands together: colour as CIE Lab (L 0…100), slightly
/// smoothed, and last the nearness to a Canny edge. In eight bytes: curves wait for memory more than for
/// arithmetic, and a picture's own colours are no finer than this.
struct PixelFeature {
  /// Of one unit of Lab, and of a nearness of 1.
  static constexpr float kLab = 256, kNear = 16384;
  std::array<std::int16_t, 4> fixed{};
  bool operator==(const PixelFeature&) const = default;

  static constexpr float unitsOf(std::size_t channel) { return channel < 3 ? kLab : kNear; }
  float operator[](std::size_t channel) const { return static_cast<float>(fixed[channel]) / unitsOf(channel); }
  /// To the nearest value there is; Lab within ±127, nearness 0 … 1.
  void set(std::size_t channel, float value) {
    const float held = std::clamp(value, channel < 3 ? -127.f : 0.f, channel < 3 ? 127.f : 1.f);
    fixed[channel] = static_cast<std::int16_t>(std::lround(held * unitsOf(channel)));
  }
};

/// Evidence for boundaries on a reduced copy of the picture. All planes are row-major with
/// width × height entries. Map pixel (i, j) has its centre at picture point
/// ((i + ½) · scaleX − ½, (j + ½) · scaleY − ½).
struct EdgeMap {
  int width = 0, height = 0;
  double scaleX = 1, scaleY = 1;  ///< picture pixels per map pixel, ≥ 1
  /// 255 on a Canny edge, else 0.
  std::vector<std::uint8_t> edges;
  /// Colour and nearness: 1 on an edge, falling linearly to 0 at `reach` map pixels (method: "Where is
  /// the boundary?"; SpineLoft 3.3.2, distance penalty).
  std::vector<PixelFeature> look;
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
