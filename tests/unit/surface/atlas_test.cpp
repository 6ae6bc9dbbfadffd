#include "engine/surface/atlas.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "engine/base/rng.h"

using namespace spineloft;
using namespace spineloft::surface;

namespace {

image::Image plain(int width, int height, std::uint8_t colour) {
  image::Image out{width, height, {}};
  out.pixels.assign(std::size_t(4) * std::size_t(width) * std::size_t(height), colour);
  return out;
}

/// Pixel rectangle of a place: left, top, right, bottom.
std::array<long, 4> pixelsOf(const Atlas& atlas, const UvArea& a) {
  const double w = atlas.pixels.width, h = atlas.pixels.height;
  return {std::lround(a.left * w), std::lround(a.top * h), std::lround(a.right * w), std::lround(a.bottom * h)};
}

}  // namespace

TEST_CASE("pictures of an atlas keep their pixels, lie apart and within it") {
  Rng rng(11);
  for (int round = 0; round < 20; ++round) {
    std::deque<image::Image> images;
    std::vector<const image::Image*> given;
    const int count = 1 + int(rng.below(30));
    for (int i = 0; i < count; ++i) {
      images.push_back(plain(1 + int(rng.below(90)), 1 + int(rng.below(90)), std::uint8_t(1 + i)));
      given.push_back(&images.back());
    }
    const auto atlas = packAtlas(given);
    REQUIRE(atlas);
    CHECK(atlas->pixels.width <= kAtlasSide);
    CHECK(atlas->pixels.height <= kAtlasSide);
    REQUIRE(atlas->places.size() == given.size());
    for (std::size_t i = 0; i < given.size(); ++i) {
      const auto [left, top, right, bottom] = pixelsOf(*atlas, atlas->places[i]);
      CHECK(right - left == given[i]->width);
      CHECK(bottom - top == given[i]->height);
      REQUIRE(left >= kAtlasPadding);
      REQUIRE(top >= kAtlasPadding);
      REQUIRE(right + kAtlasPadding <= atlas->pixels.width);
      REQUIRE(bottom + kAtlasPadding <= atlas->pixels.height);
      // Itself and its padding show its colour alone.
      int foreign = 0;
      for (long y = top - kAtlasPadding; y < bottom + kAtlasPadding; ++y) {
        for (long x = left - kAtlasPadding; x < right + kAtlasPadding; ++x) {
          foreign += atlas->pixels.pixels[4 * std::size_t(y * atlas->pixels.width + x)] == 1 + i ? 0 : 1;
        }
      }
      CHECK(foreign == 0);
    }
  }
}

TEST_CASE("what does not fit is shrunk alike until it does") {
  const image::Image a = plain(700, 500, 10), b = plain(350, 250, 20), c = plain(700, 900, 30);
  const std::array<const image::Image*, 3> given = {&a, &b, &c};
  const auto atlas = packAtlas(given, 512);
  REQUIRE(atlas);
  CHECK(atlas->pixels.width <= 512);
  CHECK(atlas->pixels.height <= 512);
  const auto widthOf = [&](std::size_t i) {
    const auto [left, top, right, bottom] = pixelsOf(*atlas, atlas->places[i]);
    return double(right - left);
  };
  CHECK(widthOf(0) == doctest::Approx(2 * widthOf(1)).epsilon(0.02));
  CHECK(widthOf(0) == doctest::Approx(widthOf(2)).epsilon(0.02));
  CHECK(widthOf(0) > 100);
}

TEST_CASE("the same picture lies in an atlas once") {
  const image::Image a = plain(100, 60, 1);
  const std::vector<const image::Image*> fifty(50, &a);
  const auto atlas = packAtlas(fifty);
  REQUIRE(atlas);
  CHECK(atlas->pixels.width * atlas->pixels.height < 2 * 110 * 70);
  for (const UvArea& place : atlas->places) CHECK(place == atlas->places[0]);
}

TEST_CASE("thousands of parts still share one atlas, and nothing makes none") {
  std::deque<image::Image> images;
  std::vector<const image::Image*> given;
  for (int i = 0; i < 3000; ++i) {
    images.push_back(plain(40, 40, std::uint8_t(i % 256)));
    given.push_back(&images.back());
  }
  const auto atlas = packAtlas(given, 1024);
  REQUIRE(atlas);
  CHECK(atlas->pixels.width <= 1024);
  CHECK(atlas->pixels.height <= 1024);
  CHECK_FALSE(packAtlas({}));
  const image::Image empty;
  const std::array<const image::Image*, 1> none = {&empty};
  CHECK_FALSE(packAtlas(none));
  CHECK_FALSE(packAtlas(given, 8));
}
