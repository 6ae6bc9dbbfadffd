#include "engine/image/sketch.h"

#include <algorithm>
#include <cmath>

namespace spineloft::image {

bool isValid(const SketchStroke& stroke) {
  const auto sound = [](float p) { return p >= 0 && p <= 1; };
  return !stroke.points.empty() && stroke.points.size() <= kMostSketchPoints &&
         (stroke.pressure.empty() || stroke.pressure.size() == stroke.points.size()) &&
         std::ranges::all_of(stroke.pressure, sound) && stroke.radius >= 0.5 &&
         stroke.radius <= 100 &&
         std::ranges::all_of(stroke.points, [](PicturePoint p) { return isFinite(p); });
}

Result<Picture> drawSketch(Size size, std::span<const Box<SketchStroke>>) {
  Picture picture;
  picture.width = picture.working.width = size.width;
  picture.height = picture.working.height = size.height;
  picture.working.pixels.assign(4 * static_cast<std::size_t>(size.width) *
                                    static_cast<std::size_t>(size.height),
                                255);
  return picture;
}

}  // namespace spineloft::image
