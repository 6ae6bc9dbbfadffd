#include "tests/bench/accuracy/true_exit.h"

#include <algorithm>
#include <cmath>

namespace spineloft::accuracy {
namespace {

enum class Ground { Part, Other, DoNotCare };

Ground groundAt(const image::Mask& mask, PicturePoint p) {
  const auto x = static_cast<long>(std::lround(p.x)), y = static_cast<long>(std::lround(p.y));
  if (x < 0 || y < 0 || x >= mask.width || y >= mask.height) return Ground::DoNotCare;
  const int value =
      mask.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(mask.width) + static_cast<std::size_t>(x)];
  return value > 200 ? Ground::Part : value > 60 ? Ground::DoNotCare : Ground::Other;
}

}  // namespace

float trueExit(const ribs::GradientCurves& curves, int curve, const image::Mask& mask) {
  constexpr double kStep = 0.25;  // picture pixels
  if (groundAt(mask, curves.point(curve, 0)) != Ground::Part) return kUnknown;
  for (int k = 1; k < curves.reached[static_cast<std::size_t>(curve)]; ++k) {
    const PicturePoint from = curves.point(curve, k - 1), to = curves.point(curve, k);
    const int steps = std::max(1, static_cast<int>(std::ceil(distance(from, to) / kStep)));
    for (int i = 1; i <= steps; ++i) {
      const Ground ground = groundAt(mask, lerp(from, to, static_cast<double>(i) / steps));
      if (ground == Ground::DoNotCare) return kUnknown;
      if (ground == Ground::Other)
        return static_cast<float>(k - 1) + (static_cast<float>(i) - 0.5f) / static_cast<float>(steps);
    }
  }
  return kUnknown;
}

}  // namespace spineloft::accuracy
