#include "engine/cli/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spineloft::cli {
namespace {

using Colour = std::array<std::uint8_t, 3>;
constexpr Colour kStroke{255, 255, 255}, kPart{255, 230, 0}, kTruth{0, 220, 255};

Colour colourOf(ribs::RibState state) {
  switch (state) {
    case ribs::RibState::Edge:
      return {60, 200, 60};
    case ribs::RibState::Bridged:
      return {255, 150, 30};
    case ribs::RibState::Guessed:
      return {230, 50, 50};
    case ribs::RibState::Edited:
    case ribs::RibState::Locked:
      return {40, 120, 255};
  }
  return kStroke;
}

/// Draws in picture coordinates on a copy that may be smaller than the picture.
class Canvas {
 public:
  explicit Canvas(const image::Picture& picture)
      : image_(picture.working),
        scaleX_(static_cast<double>(picture.width) / std::max(1, picture.working.width)),
        scaleY_(static_cast<double>(picture.height) / std::max(1, picture.working.height)) {
    for (std::size_t i = 0; i < image_.pixels.size(); ++i) {
      image_.pixels[i] = i % 4 == 3 ? 255 : static_cast<std::uint8_t>(image_.pixels[i] / 3);
    }
  }
  void dot(PicturePoint p, const Colour& colour) {
    const long x = std::lround((p.x + 0.5) / scaleX_ - 0.5);
    const long y = std::lround((p.y + 0.5) / scaleY_ - 0.5);
    if (x < 0 || y < 0 || x >= image_.width || y >= image_.height) return;
    const std::size_t at =
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) + static_cast<std::size_t>(x));
    std::copy(colour.begin(), colour.end(), image_.pixels.begin() + static_cast<std::ptrdiff_t>(at));
  }
  void line(PicturePoint a, PicturePoint b, const Colour& colour) {
    if (!isFinite(a) || !isFinite(b)) return;
    const int steps = 1 + static_cast<int>(std::min(20000.0, distance(a, b) / std::min(scaleX_, scaleY_)));
    for (int i = 0; i <= steps; ++i) dot(lerp(a, b, static_cast<double>(i) / steps), colour);
  }
  image::Image take() { return std::move(image_); }

 private:
  image::Image image_;
  double scaleX_, scaleY_;
};

}  // namespace

image::Image drawOverlay(const OverlayInput& input) {
  Canvas canvas(input.picture);
  for (const ribs::Rib& rib : input.ribs.ribs) {
    canvas.line(rib.center, rib.left, colourOf(rib.leftState));
    canvas.line(rib.center, rib.right, colourOf(rib.rightState));
  }
  image::Mask truth = input.truth;
  for (std::uint8_t& value : truth.pixels) value = value > 200 ? 255 : 0;
  for (const PicturePoint& p : outline(truth)) canvas.dot(p, kTruth);
  for (const PicturePoint& p : outline(input.part)) canvas.dot(p, kPart);
  for (std::size_t i = 1; i < input.stroke.size(); ++i) {
    canvas.line(input.stroke[i - 1], input.stroke[i], kStroke);
  }
  return canvas.take();
}

}  // namespace spineloft::cli
