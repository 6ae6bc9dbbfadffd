#include "tests/bench/accuracy/erased_outline.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

using namespace spineloft;
using namespace spineloft::accuracy;

namespace {

constexpr int kWidth = 100, kHeight = 160;
constexpr int kLeft = 40, kRight = 60;  // the bar's columns are kLeft … kRight − 1
constexpr int kTop = 20;

/// An upright bar 20 px wide on its axis from top to bottom, so that a run of the outline is 20 px.
cli::Truth truthOfBar() {
  image::Mask mask{kWidth, kHeight, std::vector<std::uint8_t>(kWidth * kHeight)};
  for (int y = kTop; y < 140; ++y) {
    for (int x = kLeft; x < kRight; ++x) mask.pixels[static_cast<std::size_t>(y * kWidth + x)] = 255;
  }
  return cli::Truth({mask, {{49.5, kTop, 20}, {49.5, 139, 20}}, 1.0});
}

image::Image picture() {
  image::Image image{kWidth, kHeight, {}};
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool in = y >= kTop && y < 140 && x >= kLeft && x < kRight;
      const auto v = static_cast<std::uint8_t>(in ? 220 : 20);
      image.pixels.insert(image.pixels.end(), {v, v, v, 255});
    }
  }
  return image;
}

int at(const image::Image& image, int x, int y) { return image.pixels[static_cast<std::size_t>(4 * (y * kWidth + x))]; }

/// The steepest step between neighbours within 4 px of a column's left border, in one row.
int steepest(const image::Image& image, int border, int y) {
  int most = 0;
  for (int x = border - 4; x < border + 4; ++x) most = std::max(most, std::abs(at(image, x, y) - at(image, x - 1, y)));
  return most;
}

}  // namespace

TEST_CASE("a point is left of the axis where a walker along it has it to the left on the screen") {
  const cli::Truth truth = truthOfBar();  // downwards: the left hand points to the right of the screen
  CHECK(truth.isLeft({60, 80}));
  CHECK_FALSE(truth.isLeft({40, 80}));
  CHECK(truth.meanWidth() == doctest::Approx(20));
}

TEST_CASE("every other half run of either side loses its edge, the opposite side keeps it there") {
  image::Image image = picture();
  REQUIRE(eraseOutline(truthOfBar(), 0.5, false, image).ok());
  for (int run = 1; run < 5; ++run) {
    const int first = kTop + 20 * run + 5, second = first + 10;
    CHECK(steepest(image, kRight, first) < 80);  // left of the axis
    CHECK(steepest(image, kLeft, first) == 200);
    CHECK(steepest(image, kRight, second) == 200);
    CHECK(steepest(image, kLeft, second) < 80);
  }
}

TEST_CASE("nothing changes farther than the halo reaches, and nothing at all where nothing is erased") {
  const image::Image before = picture();
  image::Image image = before;
  REQUIRE(eraseOutline(truthOfBar(), 0, false, image).ok());
  CHECK(image.pixels == before.pixels);
  REQUIRE(eraseOutline(truthOfBar(), 1, false, image).ok());
  for (int y = 0; y < kHeight; ++y) {
    for (const int x : {10, 30, 36, 44, 50, 55, 64, 90}) {
      if (y > kTop + 4 && y < 135) CHECK(at(image, x, y) == at(before, x, y));
    }
  }
}

TEST_CASE("on paper an erased line is the paper's colour") {
  image::Image image = picture();
  REQUIRE(eraseOutline(truthOfBar(), 1, true, image).ok());
  // The dark ground is most of the picture: the bar's rim takes its colour.
  CHECK(at(image, kLeft, 80) == 20);
  CHECK(at(image, kRight - 1, 80) == 20);
  CHECK(at(image, 50, 80) == 220);
}
