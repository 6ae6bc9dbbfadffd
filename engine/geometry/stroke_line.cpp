#include "engine/geometry/stroke_line.h"

#include <cmath>
#include <numbers>

#include "engine/geometry/polyline.h"

namespace spineloft::geometry {

bool readsForwards(std::span<const PicturePoint> stroke) {
  for (std::size_t i = 0; i < stroke.size(); ++i) {
    const PicturePoint a = stroke[i], b = stroke[stroke.size() - 1 - i];
    if (a.x != b.x) return a.x < b.x;
    if (a.y != b.y) return a.y < b.y;
  }
  return true;
}

std::vector<PicturePoint> evenStroke(std::span<const PicturePoint> stroke) {
  return resample(stroke, kStrokePoints);
}

std::vector<PicturePoint> withoutWobble(std::span<const PicturePoint> line, double share) {
  // A wobble of wavelength λ points is halved by the weight (λ / 2π)²: `smooth` damps it by
  // 1 / (1 + weight² (2π/λ)⁴).
  const double wave = share * static_cast<double>(kStrokePoints - 1);
  return smooth(line, std::pow(wave / (2 * std::numbers::pi), 2));
}

}  // namespace spineloft::geometry
