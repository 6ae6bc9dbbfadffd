#include "tests/bench/scene.h"

#include <algorithm>
#include <cmath>

#include "engine/base/rng.h"

namespace spineloft::bench {
namespace {

PicturePoint middle(image::Size size, double t) {
  return {size.width * (0.12 + 0.76 * t), size.height * (0.5 + 0.22 * std::sin(6.2 * t))};
}
double halfWidth(image::Size size, double t) { return size.height * (0.05 + 0.06 * t); }

}  // namespace

std::vector<PicturePoint> tubeStroke(image::Size size, int count) {
  std::vector<PicturePoint> points;
  for (int i = 0; i < count; ++i) points.push_back(middle(size, static_cast<double>(i) / (count - 1)));
  return points;
}

image::Picture tubePicture(image::Size size) {
  Rng rng(20261121);
  image::Image image{size.width, size.height, {}};
  image.pixels.reserve(4 * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      // The tube is steep nowhere: the nearest middle point is near the same column.
      double inside = -1e9, along = 0;
      for (double t = -0.06; t <= 0.06; t += 0.01) {
        const double at = std::clamp((x / static_cast<double>(size.width) - 0.12) / 0.76 + t, 0.0, 1.0);
        const double depth = halfWidth(size, at) - distance(middle(size, at), PicturePoint{1.0 * x, 1.0 * y});
        if (depth > inside) inside = depth, along = at;
      }
      const double cover = std::clamp(inside + 0.5, 0.0, 1.0);
      const double ground = 150 + 25 * std::sin(0.05 * x + 0.11 * y) + 20 * std::sin(0.31 * x - 0.02 * y);
      const double tube = std::fmod(along * 9, 1.0) < 0.5 ? 90 : 60;
      for (const double tint : {1.0, 0.9, 0.75}) {
        const double value = tint * (ground + cover * (tube - ground)) + rng.uniform(-8, 8);
        image.pixels.push_back(static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0)));
      }
      image.pixels.push_back(255);
    }
  }
  return image::makePicture(std::move(image));
}

}  // namespace spineloft::bench
