#include "engine/vision/cut_out.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "engine/base/rng.h"

using namespace spineloft;
using namespace spineloft::vision;

namespace {

/// A soft-edged disc of one colour on noisy ground of another.
image::Picture discPicture(int width, int height, PicturePoint centre, double radius) {
  Rng rng(7);
  image::Picture picture;
  picture.width = width;
  picture.height = height;
  picture.working = {width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double in = std::clamp(radius - std::hypot(x - centre.x, y - centre.y) + 0.5, 0.0, 1.0);
      const double noise = rng.uniform(-12, 12);
      const auto mix = [&](double ground, double disc) {
        return static_cast<std::uint8_t>(std::clamp(ground + in * (disc - ground) + noise, 0.0, 255.0));
      };
      picture.working.pixels.insert(picture.working.pixels.end(),
                                    {mix(120, 220), mix(160, 90), mix(110, 60), std::uint8_t{255}});
    }
  }
  return picture;
}

double areaOf(std::span<const PicturePoint> outline) {
  double twice = 0;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    twice += cross(outline[j], outline[i]);
  }
  return std::abs(twice) / 2;
}

}  // namespace

TEST_CASE("a tap or a box cuts a disc out to a pixel of the copy, the same every time") {
  for (const int scale : {1, 3}) {
    const double r = 60.0 * scale;
    const PicturePoint centre{130.0 * scale, 100.0 * scale};
    const image::Picture picture = discPicture(280 * scale, 200 * scale, centre, r);
    CutHints tap, box;
    tap.inside = {{centre.x + r / 2, centre.y}};
    box.box = {{centre.x - 1.2 * r, centre.y - 1.2 * r}, {centre.x + 1.2 * r, centre.y + 1.2 * r}};
    for (const CutHints& hints : {tap, box}) {
      const auto found = cutOut(picture, hints);
      REQUIRE(found.ok());
      REQUIRE(found.value().size() == 1);
      CHECK(areaOf(found.value()[0]) == doctest::Approx(std::numbers::pi * r * r).epsilon(0.04));
      const double pixel = std::max(1.0, 280.0 * scale / kCutSide);
      for (const PicturePoint p : found.value()[0]) {
        CHECK(std::abs(distance(p, centre) - r) < 2.5 * pixel);
      }
      CHECK(cutOut(picture, hints).value() == found.value());
    }
  }
}

TEST_CASE("a plain picture, no hint and hints beside the picture are refused") {
  image::Picture plain = discPicture(100, 80, {50, 40}, 0);
  for (std::uint8_t& v : plain.working.pixels) v = 255;
  CutHints tap;
  tap.inside = {{50, 40}};
  CHECK(cutOut(plain, tap).error() == Error::NothingCutOut);
  CHECK(cutOut(plain, {}).error() == Error::ValueOutOfRange);
  tap.inside = {{500, 40}};
  CHECK(cutOut(plain, tap).error() == Error::ValueOutOfRange);
  tap.inside = {{std::nan(""), 40}};
  CHECK(cutOut(plain, tap).error() == Error::ValueOutOfRange);
  CHECK(cutOut(image::Picture{}, tap).error() == Error::PictureEmpty);
}
