#include "engine/geometry/stroke_line.h"

#include <cmath>
#include <numbers>

namespace spineloft::geometry {

bool readsForwards(std::span<const PicturePoint> stroke) {
  for (std::size_t i = 0; i < stroke.size(); ++i) {
    const PicturePoint a = stroke[i], b = stroke[stroke.size() - 1 - i];
    if (a.x != b.x) return a.x < b.x;
    if (a.y != b.y) return a.y < b.y;
  }
  return true;
}

void spreadEvenly(std::vector<PicturePoint>& line, std::size_t count, StrokeMemory& memory) {
  resample(std::span<const PicturePoint>(line), count, memory.lengths, memory.spare);
  line.swap(memory.spare);
}

void smoothWobble(std::vector<PicturePoint>& line, double share, StrokeMemory& memory) {
  // A wobble of wavelength λ points is halved by the weight (λ / 2π)²: `smooth` damps it by
  // 1 / (1 + weight² (2π/λ)⁴).
  const double wave = share * static_cast<double>(kStrokePoints - 1);
  smooth(line, std::pow(wave / (2 * std::numbers::pi), 2), memory.smooth);
}

double lengthOf(std::span<const PicturePoint> line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += distance(line[i - 1], line[i]);
  return length;
}

}  // namespace spineloft::geometry
